// SPDX-License-Identifier: MIT
#include "homolog/match/soft_assignment.h"

#include <cmath>

#include "homolog/base/widest_clone.h"

namespace homolog {
namespace {

constexpr float outlier_share = 0.1f;  // of the mean sum of weights: what has no partner is not drawn anywhere
constexpr float farthest = 12;         // where the weight is nothing: e^-12 is subtracted
constexpr std::size_t lanes = 8;       // samples at once

// x becomes e^x, for x <= 0, to 2e-7: a power of two, and for the rest, |f| <= 1/2, the Taylor series of 2^f, whose coefficients are
// (ln 2)^k / k!.
[[gnu::always_inline]] inline void exponentiate(EightFloats& x) {
  using Ints [[gnu::vector_size(32)]] = int;
  const EightFloats lowest = EightFloats{} - 80;  // as good as nothing, and the power of two still normal
  const EightFloats t = (x > lowest ? x : lowest) * 1.44269504f;
  const Ints whole = __builtin_convertvector(t - 0.5f, Ints);  // rounds, for t is negative
  const EightFloats f = t - __builtin_convertvector(whole, EightFloats);
  EightFloats power = 0.00015403530f * f + 0.0013333558f;
  for (const float coefficient : {0.0096181291f, 0.055504109f, 0.24022651f, 0.69314718f, 1.0f}) power = power * f + coefficient;
  x = power * reinterpret_cast<EightFloats>((whole + 127) << 23);
}

// A place of the skin as the blocks see it.
struct Place {
  Eigen::Vector3f y, n;
  LimbPlace on;
};

std::vector<Place> places_of(const std::vector<SurfaceSample>& skin, const Vec3& middle, const std::vector<LimbPlace>& limb_places) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    places.push_back(
        {(skin[i].position - middle).cast<float>(), skin[i].normal.cast<float>(), limb_places.empty() ? LimbPlace{} : limb_places[i]});
  }
  return places;
}

// How nearness falls with distance, and whether along the limbs.
struct Falloff {
  float steepness;  // 1 / (2 reach^2)
  float nothing;    // e^-12
  bool on_limbs;
};

// Which blocks are near every place, place after place, and sixteen weights for each.
struct Weights {
  std::vector<std::size_t> first{0};
  std::vector<std::size_t> block;
  Eigen::ArrayXf weight;
};

Weights near_blocks(const std::vector<Place>& places, const SampleBlocks& data, float limit) {
  Weights weights;
  for (const Place& place : places) {
    for (std::size_t b = 0; b < data.balls.size(); ++b) {
      if (may_reach(data.balls[b], place.y, limit)) weights.block.push_back(b);
    }
    weights.first.push_back(weights.block.size());
  }
  weights.weight.resize(static_cast<Eigen::Index>(weights.block.size()) * block_size);
  return weights;
}

// The weights of place i, added to the sums of the samples (sixteen a block) and to sixteen sums of the place.
HOMOLOG_WIDEST_CLONE void add_weights(const Place& place, std::size_t i, const SampleBlock* blocks, const Falloff& falloff,
                                      Weights& weights, float* sample_sums, float* sums) {
  const EightFloats zero = {};
  for (std::size_t b = weights.first[i]; b < weights.first[i + 1]; ++b) {
    const SampleBlock& block = blocks[weights.block[b]];
    for (std::size_t k = 0; k < block_size; k += lanes) {
      const EightFloats x = eight(block.x.data() + k) - place.y.x(), y = eight(block.y.data() + k) - place.y.y(),
                        z = eight(block.z.data() + k) - place.y.z();
      EightFloats nearness = -falloff.steepness * (x * x + y * y + z * z);
      if (falloff.on_limbs) {
        const EightFloats out = eight(block.out.data() + k), both = out * place.on.out;
        nearness -= 0.5f * (out * out + place.on.out * place.on.out - 2 * (eight(block.limb.data() + k) == place.on.limb ? both : zero));
      }
      exponentiate(nearness);
      nearness -= falloff.nothing;
      const EightFloats agreement =
          eight(block.nx.data() + k) * place.n.x() + eight(block.ny.data() + k) * place.n.y() + eight(block.nz.data() + k) * place.n.z();
      const EightFloats weight = (nearness > 0 ? nearness : zero) * (agreement > 0 ? agreement * agreement : zero);
      eight(weights.weight.data() + b * block_size + k) = weight;
      eight(sample_sums + weights.block[b] * block_size + k) += weight;
      eight(sums + k) += weight;
    }
  }
}

// The samples weighted as place i and samples share them, in five times sixteen sums: x, y, z, mass, and what they lie below i's tangent
// plane, twice.
HOMOLOG_WIDEST_CLONE void add_up(const Place& place, std::size_t i, const SampleBlock* blocks, const Weights& weights, float by_place,
                                 const float* by_sample, float* sums) {
  for (std::size_t k = 0; k < block_size; k += lanes) {
    EightFloats total[5] = {};
    for (std::size_t b = weights.first[i]; b < weights.first[i + 1]; ++b) {
      const SampleBlock& block = blocks[weights.block[b]];
      const EightFloats share =
          eight(weights.weight.data() + b * block_size + k) * (eight(by_sample + weights.block[b] * block_size + k) + by_place);
      const EightFloats x = eight(block.x.data() + k), y = eight(block.y.data() + k), z = eight(block.z.data() + k);
      total[0] += share * x;
      total[1] += share * y;
      total[2] += share * z;
      total[3] += share;
      total[4] += share * ((x - place.y.x()) * (eight(block.nx.data() + k) - place.n.x()) +
                           (y - place.y.y()) * (eight(block.ny.data() + k) - place.n.y()) +
                           (z - place.y.z()) * (eight(block.nz.data() + k) - place.n.z()));
    }
    for (std::size_t n = 0; n < 5; ++n) eight(sums + n * block_size + k) = total[n];
  }
}

// One over the sums, and over what the outliers take: half of a unit's mass for each way of assigning.
Eigen::ArrayXf half_over(const Eigen::ArrayXf& sums) { return 0.5f / (sums + outlier_share * sums.mean() + 1e-12f); }

}  // namespace

Pull assign_softly(const std::vector<SurfaceSample>& skin, const SampleBlocks& data, double reach,
                   const std::vector<LimbPlace>& limb_places) {
  const Falloff falloff{static_cast<float>(0.5 / (reach * reach)), std::exp(-farthest), !limb_places.empty()};
  const std::vector<Place> places = places_of(skin, data.middle, limb_places);
  Weights weights = near_blocks(places, data, std::sqrt(farthest / falloff.steepness));
  Eigen::ArrayXf place_sums(skin.size()), sample_sums = Eigen::ArrayXf::Zero(data.blocks.size() * block_size);
  for (std::size_t i = 0; i < skin.size(); ++i) {
    BlockFloats sums = BlockFloats::Zero();
    add_weights(places[i], i, data.blocks.data(), falloff, weights, sample_sums.data(), sums.data());
    place_sums[i] = sums.sum();
  }
  const Eigen::ArrayXf by_place = half_over(place_sums), by_sample = half_over(sample_sums);
  Pull pull{std::vector<Vec3>(skin.size(), Vec3::Zero()), std::vector<double>(skin.size(), 0)};
  for (std::size_t i = 0; i < skin.size(); ++i) {
    Eigen::Array<float, block_size, 5> sums;
    add_up(places[i], i, data.blocks.data(), weights, by_place[i], by_sample.data(), sums.data());
    const Eigen::Array<float, 5, 1> total = sums.colwise().sum();
    pull.masses[i] = total[3];
    if (total[3] > 1e-9f) {
      const Eigen::Vector3f place = (total.head<3>() / total[3]).matrix() + (total[4] / (2 * total[3])) * places[i].n;
      pull.places[i] = data.middle + place.cast<double>();
    }
  }
  return pull;
}

}  // namespace homolog
