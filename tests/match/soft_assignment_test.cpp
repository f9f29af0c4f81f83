// SPDX-License-Identifier: MIT
// The blocks weigh as the plain formula does, sample by sample.
#include "homolog/match/soft_assignment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "match/synthetic_pairs.h"

namespace homolog {
namespace {

std::vector<SurfaceSample> scattered(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<SurfaceSample> samples;
  for (int i = 0; i < count; ++i) {
    const Vec3 position = synthetic::in_cube(random) + Vec3(100, -50, 0);
    samples.push_back({position, (synthetic::in_cube(random) - Vec3::Constant(0.5)).normalized()});
  }
  return samples;
}

std::vector<LimbPlace> scattered_on_limbs(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<LimbPlace> places;
  for (int i = 0; i < count; ++i) {
    const Vec3 drawn = synthetic::in_cube(random);
    places.push_back({std::floor(static_cast<float>(drawn.x() * 3)), static_cast<float>(std::max(0.0, 4 * drawn.y() - 1))});
  }
  return places;
}

double square_away(const LimbPlace& a, const LimbPlace& b) {
  return a.limb == b.limb ? std::pow(a.out - b.out, 2) : std::pow(a.out, 2) + std::pow(b.out, 2);
}

Pull plain(const std::vector<SurfaceSample>& skin, const std::vector<SurfaceSample>& data, double reach,
           const std::vector<LimbPlace>& skin_limbs, const std::vector<LimbPlace>& data_limbs) {
  Eigen::MatrixXd w(skin.size(), data.size());
  for (std::size_t i = 0; i < skin.size(); ++i) {
    for (std::size_t k = 0; k < data.size(); ++k) {
      const double square = (skin[i].position - data[k].position).squaredNorm() / (reach * reach);
      const double nearness = std::exp(-0.5 * (square + square_away(skin_limbs[i], data_limbs[k]))) - std::exp(-12);
      const double agreement = skin[i].normal.dot(data[k].normal);
      w(i, k) = nearness > 0 && agreement > 0 ? nearness * agreement * agreement : 0;
    }
  }
  const Eigen::VectorXd rows = w.rowwise().sum(), columns = w.colwise().sum();
  const double row_outliers = 0.1 * rows.mean() + 1e-12;
  const double column_outliers = 0.1 * columns.sum() / (16 * std::ceil(static_cast<double>(data.size()) / 16)) + 1e-12;
  Pull pull{std::vector<Vec3>(skin.size(), Vec3::Zero()), std::vector<double>(skin.size(), 0)};
  for (std::size_t i = 0; i < skin.size(); ++i) {
    for (std::size_t k = 0; k < data.size(); ++k) {
      const double share = 0.5 * w(i, k) * (1 / (rows[i] + row_outliers) + 1 / (columns[k] + column_outliers));
      const double sagitta = 0.5 * (data[k].position - skin[i].position).dot(data[k].normal - skin[i].normal);
      pull.masses[i] += share;
      pull.places[i] += share * (data[k].position + sagitta * skin[i].normal);
    }
    if (pull.masses[i] > 1e-9) pull.places[i] /= pull.masses[i];
  }
  return pull;
}

void expect_same(const Pull& fast, const Pull& clear) {
  for (std::size_t i = 0; i < clear.masses.size(); ++i) {
    EXPECT_NEAR(fast.masses[i], clear.masses[i], 1e-4 * (clear.masses[i] + 1e-3));
    if (clear.masses[i] > 1e-6) EXPECT_LT((fast.places[i] - clear.places[i]).norm(), 1e-4);
  }
}

TEST(SoftAssignment, IsThePlainFormula) {
  for (const int count : {1, 16, 100, 333}) {
    const auto skin = scattered(60, 1), data = scattered(count, 2);
    for (const double reach : {0.02, 0.1, 0.5}) {
      const std::vector<LimbPlace> trunk(60), data_trunk(count);
      expect_same(assign_softly(skin, make_blocks(data), reach), plain(skin, data, reach, trunk, data_trunk));
      const auto limbs = scattered_on_limbs(60, 5), data_limbs = scattered_on_limbs(count, 6);
      expect_same(assign_softly(skin, make_blocks(data, data_limbs), reach, limbs), plain(skin, data, reach, limbs, data_limbs));
    }
  }
}

// On a ball every sample lies as far below a place's tangent plane as its chord bulges: nothing draws the place in or out.
TEST(SoftAssignment, ABallDrawsASkinOnItNeitherInNorOut) {
  std::vector<SurfaceSample> ball = scattered(2000, 3), skin = scattered(50, 4);
  for (auto* samples : {&ball, &skin}) {
    for (SurfaceSample& s : *samples) s.position = 3 * s.normal;
  }
  const Pull pull = assign_softly(skin, make_blocks(ball), 0.6);
  for (std::size_t i = 0; i < skin.size(); ++i) EXPECT_NEAR(pull.places[i].dot(skin[i].normal), 3, 1e-4);
}

TEST(SoftAssignment, NobodyIsDrawnWhereThereIsNothing) {
  const Pull pull = assign_softly(scattered(3, 1), make_blocks({{Vec3::Constant(1e3), Vec3::UnitX()}}), 0.1);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(pull.masses[i], 0);
    EXPECT_EQ(pull.places[i], Vec3::Zero());
  }
}

}  // namespace
}  // namespace homolog
