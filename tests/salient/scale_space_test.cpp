// SPDX-License-Identifier: MIT
// Sec. 4.2, 4.3: what balls, cylinders, plates and half-spaces answer.
#include "homolog/salient/scale_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fixtures/solids.h"
#include "homolog/salient/gaussian_blur.h"

namespace homolog {
namespace {

using namespace fixtures;

GridFrame unit_grid(int x, int y, int z) { return {{2 * x + 1, 2 * y + 1, 2 * z + 1}, Vec3(-x, -y, -z), 1}; }

// Calls visit(level, i, j, k, value) for every voxel of every level of an octave's new slices.
template <class Visit>
void visit_new_voxels(const Octave& octave, const Visit& visit) {
  for (int level = 0; level < octave.levels(); ++level) {
    for (int k = octave.first; k < octave.end; ++k) {
      for (int j = 0; j < octave.frame().size[1]; ++j) {
        for (int i = 0; i < octave.frame().size[0]; ++i) visit(level, i, j, k, octave.at(level, i, j, k));
      }
    }
  }
}

// The octaves as whole volumes, level by level.
std::vector<std::vector<Volume<float>>> whole_octaves(const Interior& interior, int reach = 0) {
  std::vector<std::vector<Volume<float>>> octaves;
  for_each_octave(interior, {}, reach, [&](const Octave& octave) {
    if (octave.first == 0) {
      const Volume<float> empty{octave.frame(), std::vector<float>(octave.frame().voxels())};
      octaves.emplace_back(octave.levels(), empty);
    }
    visit_new_voxels(octave, [&](std::size_t level, int i, int j, int k, float value) { octaves.back()[level].at(i, j, k) = value; });
  });
  return octaves;
}

// The strongest response within `reach` of the origin, over the levels of the first octave.
double strongest_near_origin(const Solid& solid, const GridFrame& frame, double reach) {
  double strongest = 0;
  const auto octaves = whole_octaves(rasterize(solid, frame));
  for (const Volume<float>& level : octaves[0]) {
    const GridFrame& f = level.frame;
    for (int k = 0; k < f.size[2]; ++k) {
      for (int j = 0; j < f.size[1]; ++j) {
        for (int i = 0; i < f.size[0]; ++i) {
          if (f.world_from_voxel(Vec3(i, j, k)).cwiseAbs().maxCoeff() < reach) strongest = std::max<double>(strongest, level.at(i, j, k));
        }
      }
    }
  }
  return strongest;
}

// Blurred by the plain sum along one axis, zero outside.
Volume<float> plainly_blurred(const Volume<float>& volume, const std::vector<float>& weights, int axis) {
  Volume<float> blurred = volume;
  const int radius = static_cast<int>(weights.size()) - 1;
  const auto& [nx, ny, nz] = volume.frame.size;
  const auto value = [&](std::array<int, 3> v, int t) {
    v[axis] += t;
    return volume.frame.contains(v[0], v[1], v[2]) ? volume.at(v[0], v[1], v[2]) : 0.0f;
  };
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        float sum = 0;
        for (int t = -radius; t <= radius; ++t) sum = std::fma(weights[std::abs(t)], value({i, j, k}, t), sum);
        blurred.at(i, j, k) = sum;
      }
    }
  }
  return blurred;
}

// Along z, y and x; `plateau` is what constant coverage has become so far.
Volume<float> plainly_blurred(Volume<float> volume, double sigma, float& plateau) {
  for (const int axis : {2, 1, 0}) volume = plainly_blurred(volume, gaussian_kernel(sigma), axis);
  plateau = GaussianBlur(sigma).plateau_after(plateau);
  for (float& value : volume.values) value = value < nearly_zero ? 0 : value > plateau - nearly_plateau ? plateau : value;
  return volume;
}

// The voxels of a volume on another frame whose voxels coincide with some of its own, zero outside.
Volume<float> on_frame(const Volume<float>& volume, const GridFrame& frame) {
  Volume<float> picked{frame, std::vector<float>(frame.voxels())};
  for (int z = 0; z < frame.size[2]; ++z) {
    for (int y = 0; y < frame.size[1]; ++y) {
      for (int x = 0; x < frame.size[0]; ++x) {
        const Vec3 place = volume.frame.voxel_from_world(frame.world_from_voxel(Vec3(x, y, z)));
        const std::array<int, 3> v{static_cast<int>(std::lround(place[0])), static_cast<int>(std::lround(place[1])),
                                   static_cast<int>(std::lround(place[2]))};
        if (volume.frame.contains(v[0], v[1], v[2])) picked.at(x, y, z) = volume.at(v[0], v[1], v[2]);
      }
    }
  }
  return picked;
}

// The fast way gives the bytes of the plain one: whole volumes, one level after the other, three loops each; every second voxel of the
// level with twice the blur begins the next octave.
TEST(ScaleSpace, GrowingOctavesEqualPlainOnesBitByBit) {
  const Interior interior = rasterize(join({ball({-19, 2, 1}, 15), ball({19, -3, 0}, 3)}), unit_grid(36, 18, 17));
  const SalientParams params;
  const double k = std::cbrt(2);
  for (const int reach : {0, 3}) {
    const auto octaves = whole_octaves(interior, reach);
    ASSERT_GE(octaves.size(), 2u);
    float plateau = 1;
    Volume<float> fine = on_frame(interior, octaves[0][0].frame);  // G(s_0) of the octave, once blurred
    fine = plainly_blurred(fine, std::sqrt(params.sigma0 * params.sigma0 - 1.0 / 12), plateau);
    for (const std::vector<Volume<float>>& octave : octaves) {
      Volume<float> doubled;
      float doubled_plateau = 0;
      for (std::size_t level = 0; level < octave.size(); ++level) {
        const Volume<float> coarse = plainly_blurred(fine, params.sigma0 * std::pow(k, level) * std::sqrt(k * k - 1), plateau);
        const auto factor = static_cast<float>(-1 / (std::log(k) * ball_response(k)));
        for (std::size_t v = 0; v < fine.values.size(); ++v) {
          ASSERT_EQ(octave[level].values[v], factor * (fine.values[v] - coarse.values[v])) << level;
        }
        fine = coarse;
        if (level + 1 == static_cast<std::size_t>(params.levels_per_octave)) doubled = fine, doubled_plateau = plateau;
      }
      if (&octave != &octaves.back()) fine = on_frame(doubled, (&octave + 1)->front().frame);
      plateau = doubled_plateau;
    }
  }
}

TEST(ScaleSpace, BallFormulasHaveThePapersLimits) {
  EXPECT_NEAR(ball_response(1.0001), -std::sqrt(2 / M_PI) * 3 * std::sqrt(3) * std::exp(-1.5), 1e-4);  // -0.925
  EXPECT_NEAR(radius_factor(1.0001), std::sqrt(3), 1e-4);
  const double k = std::cbrt(2);
  EXPECT_NEAR(radius_factor(k), 1.72438, 1e-5);
  for (const double off : {0.97, 1.03}) EXPECT_GT(ball_level(off / radius_factor(k), k), ball_response(k));  // it is the minimum
}

TEST(ScaleSpace, ResponseTellsPlaneSlabCylinderBall) {
  EXPECT_NEAR(strongest_near_origin(box({-30, 0, 0}, {30, 34, 34}), unit_grid(30, 34, 34), 8), 0.26, 0.01);       // half-space x < 0
  EXPECT_NEAR(strongest_near_origin(box({0, 0, 0}, {4, 30, 30}), unit_grid(6, 32, 32), 8), 0.52, 0.01);           // slab
  EXPECT_NEAR(strongest_near_origin(cylinder({-30, 0, 0}, {30, 0, 0}, 5), unit_grid(32, 8, 8), 8), 0.79, 0.015);  // long cylinder
  EXPECT_NEAR(strongest_near_origin(ball({0, 0, 0}, 5), unit_grid(8, 8, 8), 8), 1, 0.03);  // at the nearest level, not the best scale
}

// The same grid centre must have the same scale-normalised value in either octave, however the margins were laid.
TEST(ScaleSpace, OctavesAgreeWhereTheyOverlap) {
  const auto octaves = whole_octaves(rasterize(hand(), 80));
  for (std::size_t o = 1; o < octaves.size(); ++o) {
    const Volume<float>&fine = octaves[o - 1][octaves[o - 1].size() - 2], &coarse = octaves[o][0];
    double worst = 0;
    const GridFrame& f = coarse.frame;
    for (int k = 0; k < f.size[2]; ++k) {
      for (int j = 0; j < f.size[1]; ++j) {
        for (int i = 0; i < f.size[0]; ++i) {
          const Vec3 v = fine.frame.voxel_from_world(f.world_from_voxel(Vec3(i, j, k)));
          const int x = static_cast<int>(std::lround(v[0])), y = static_cast<int>(std::lround(v[1])),
                    z = static_cast<int>(std::lround(v[2]));
          ASSERT_LT((v - Vec3(x, y, z)).norm(), 1e-6);  // every coarse voxel is a fine one
          if (fine.frame.contains(x, y, z)) worst = std::max<double>(worst, std::abs(fine.at(x, y, z) - coarse.at(i, j, k)));
        }
      }
    }
    EXPECT_LT(worst, 3e-3);
  }
}

TEST(ScaleSpace, SigmasGrowByTheSameFactor) {
  for_each_octave(rasterize(hand(), 40), {}, 0,
                  [](const Octave& octave) { EXPECT_NEAR(octave.sigmas[0] * std::cbrt(2), octave.sigmas[1], 1e-12); });
}

// What a visitor may look at is the same however far it may look, and every slice is new once.
TEST(ScaleSpace, ReachKeepsTheSurroundings) {
  constexpr int reach = 5;
  const Interior interior = rasterize(hand(), 64);
  const auto octaves = whole_octaves(interior);
  std::size_t number = 0;
  int end = 0;
  for_each_octave(interior, {}, reach, [&](const Octave& octave) {
    if (octave.first == 0 && end > 0) ++number;
    EXPECT_EQ(octave.first, octave.first == 0 ? 0 : end);
    end = octave.end;
    const int low = std::max(0, octave.first - reach), high = std::min(octave.frame().size[2], octave.end + reach);
    for (int level = 0; level < octave.levels(); ++level) {
      for (int k = low; k < high; ++k) {
        for (int j = 0; j < octave.frame().size[1]; ++j) {
          for (int i = 0; i < octave.frame().size[0]; ++i) ASSERT_EQ(octave.at(level, i, j, k), octaves[number][level].at(i, j, k)) << k;
        }
      }
    }
  });
  EXPECT_EQ(number + 1, octaves.size());
}

TEST(ScaleSpace, EmptyInteriorHasNoOctaves) {
  Interior nothing{unit_grid(5, 5, 5), std::vector<float>(11 * 11 * 11)};
  for_each_octave(nothing, {}, 0, [](const Octave&) { FAIL(); });
}

}  // namespace
}  // namespace homolog
