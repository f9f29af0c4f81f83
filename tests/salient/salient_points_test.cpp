// SPDX-License-Identifier: MIT
// Sec. 4.2, 4.3: where salient points stand, how large they are, and that neither grid, turn nor threads decide.
#include "homolog/salient/salient_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fixtures/solids.h"
#include "homolog/base/parallel.h"
#include "homolog/salient/refine_peak.h"
#include "homolog/salient/scale_space.h"

namespace homolog {
namespace {

using namespace fixtures;

// A grid of unit voxels around the origin.
GridFrame unit_grid(int half) { return {{2 * half + 1, 2 * half + 1, 2 * half + 1}, Vec3::Constant(-half), 1}; }

TEST(SalientPoints, RadiusOfABallIsRightWithinHalfAPercent) {
  for (const double r : {4.0, 5.0, 7.0, 10.0, 16.0, 26.0}) {
    const int jitters = r < 12 ? 6 : 3;
    double sum = 0;
    for (int n = 0; n < jitters; ++n) {
      const Vec3 centre = random_rotation(n) * Vec3(0.4, 0.25, 0.1);
      const auto points = find_salient_points(rasterize(ball(centre, r), unit_grid(static_cast<int>(r) + 2)), {});
      ASSERT_EQ(points.size(), 1u) << r;
      EXPECT_NEAR(points[0].radius / r, 1, 0.01) << r;
      EXPECT_NEAR(points[0].response, 1, 0.02) << r;
      EXPECT_LT((points[0].position - centre).norm(), 0.02 * r) << r;
      sum += points[0].radius / r;
    }
    EXPECT_NEAR(sum / jitters, 1, 0.005) << r;
  }
}

// Eight voxels tie exactly; a strict comparison with all neighbours would lose the ball.
TEST(SalientPoints, BallCentredBetweenVoxelsIsFoundOnce) {
  const auto points = find_salient_points(rasterize(ball(Vec3::Constant(0.5), 6), unit_grid(9)), {});
  ASSERT_EQ(points.size(), 1u);
  EXPECT_LT((points[0].position - Vec3::Constant(0.5)).norm(), 0.02);
}

// Radii from one octave border to the next: every ball once, none lost or doubled.
TEST(SalientPoints, NothingIsLostOrDoubledBetweenOctaves) {
  for (double r = 6.5; r < 15; r *= 1.03) {
    const auto points = find_salient_points(rasterize(ball({0.1, 0.2, 0.3}, r), unit_grid(17)), {});
    ASSERT_EQ(points.size(), 1u) << r;
    EXPECT_NEAR(points[0].radius / r, 1, 0.01) << r;
  }
}

// Whether a voxel exceeds all 80 neighbours in space and scale; no tie counts.
bool tops_all_neighbours(const Octave& octave, int level, int i, int j, int k) {
  for (int n = 0; n < 81; ++n) {
    if (n == 40) continue;
    if (octave.at(level - 1 + n / 27, i - 1 + n % 3, j - 1 + n / 3 % 3, k - 1 + n / 9 % 3) >= octave.at(level, i, j, k)) return false;
  }
  return true;
}

// The plain search: all voxels of all levels but those next to another octave, whose peaks may be told by that one.
std::vector<SalientPoint> plain_points(const Interior& interior, const SalientParams& params, double least_sheet_fall) {
  const double k = std::cbrt(2);
  const ScaleCorrection correction(k);
  std::vector<SalientPoint> points;
  for_each_octave(interior, params, refinement_reach(params), [&](const Octave& octave) {
    const auto& size = octave.frame().size;
    for (int z = std::max(1, octave.first); z < std::min(size[2] - 1, octave.end); ++z) {
      for (int y = 1; y + 1 < size[1]; ++y) {
        for (int x = 1; x + 1 < size[0]; ++x) {
          for (int level = 2; level + 2 < octave.levels(); ++level) {
            if (octave.at(level, x, y, z) < 0.2F || !tops_all_neighbours(octave, level, x, y, z)) continue;
            const RefinedPeak peak = refine_peak(octave, {level, {x, y, z}}, k, correction);
            if (peak.point.response >= params.threshold && peak.sheet_fall > least_sheet_fall) points.push_back(peak.point);
          }
        }
      }
    }
  });
  return points;
}

TEST(SalientPoints, AreThoseOfThePlainSearch) {
  std::size_t all = 0;
  for (const Solid& solid : {hand(), biplane(), quadruped()}) {
    const Interior interior = rasterize(moved(solid, {random_rotation(3), 1, Vec3::Zero()}), 96);
    const SalientParams params;
    const auto points = find_salient_points(interior, params), plain = plain_points(interior, params, 0.01);
    all += plain.size();
    for (const SalientPoint& point : plain) {
      const bool told = std::any_of(points.begin(), points.end(), [&](const SalientPoint& other) {
        return (other.position - point.position).norm() < 0.25 * point.radius && other.radius / point.radius < 1.2 &&
               point.radius / other.radius < 1.2;
      });
      EXPECT_TRUE(told) << point.position.transpose() << " r " << point.radius << " response " << point.response;
    }
  }
  EXPECT_GE(all, 10u);
}

TEST(SalientPoints, WorldFrameIsKept) {
  const Solid small = ball({0, 0, 0}, 1), large = moved(small, {random_rotation(1), 3, {10, -20, 5}});
  const auto points = find_salient_points(rasterize(large, 30), {});
  ASSERT_EQ(points.size(), 1u);
  EXPECT_LT((points[0].position - Vec3(10, -20, 5)).norm(), 0.03);
  EXPECT_NEAR(points[0].radius, 3, 0.03);
}

TEST(SalientPoints, SortedByRadiusAndAboveTheThreshold) {
  SalientParams params;
  params.threshold = 0.3;
  const auto points = find_salient_points(rasterize(hand(), 96), params);
  ASSERT_GT(points.size(), 6u);
  EXPECT_TRUE(std::is_sorted(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.radius > b.radius; }));
  for (const SalientPoint& p : points) EXPECT_GE(p.response, 0.3);
}

// The share of points of either that the other has within .35 r and .3 in log r.
double repeated(const std::vector<SalientPoint>& a, const std::vector<SalientPoint>& b) {
  const auto found = [](const SalientPoint& p, const std::vector<SalientPoint>& others) {
    return std::any_of(others.begin(), others.end(), [&](const SalientPoint& q) {
      return (p.position - q.position).norm() < 0.35 * std::min(p.radius, q.radius) && std::abs(std::log(p.radius / q.radius)) < 0.3;
    });
  };
  const auto hits = std::count_if(a.begin(), a.end(), [&](const auto& p) { return found(p, b); }) +
                    std::count_if(b.begin(), b.end(), [&](const auto& p) { return found(p, a); });
  return static_cast<double>(hits) / static_cast<double>(a.size() + b.size());
}

std::vector<SalientPoint> points_of_turned(const Solid& solid, const Mat3& rotation, int resolution) {
  auto points = find_salient_points(rasterize(moved(solid, {rotation, 1, Vec3::Zero()}), resolution), {});
  for (SalientPoint& p : points) p.position = rotation.transpose() * p.position;
  return points;
}

// Points along a straight limb slide from turn to turn; the others stay.
TEST(SalientPoints, RepeatUnderRotation) {
  for (const Solid& solid : {hand(), quadruped()}) {
    const auto first = points_of_turned(solid, random_rotation(1), 112);
    double sum = 0;
    for (std::uint32_t turn = 2; turn < 5; ++turn) sum += repeated(first, points_of_turned(solid, random_rotation(turn), 112));
    EXPECT_GT(sum / 3, 0.75);
  }
}

// A plate 6 voxels thick answers .52 all over its middle: peaks there are the grid's, not the plate's.
TEST(SalientPoints, EvenPlateHasNoPointsOfTheGrid) {
  const Solid plate = box({0, 0, 0}, {40, 26, 3});
  const Vec3 shift(0.3, 0.1, 0.2);
  for (std::uint32_t turn = 0; turn < 10; ++turn) {
    const Mat3 rotation = turn == 0 ? Mat3(Mat3::Identity()) : random_rotation(turn);
    int inner = 0;
    for (const SalientPoint& p : find_salient_points(rasterize(moved(plate, {rotation, 1, shift}), unit_grid(50)), {})) {
      const Vec3 x = rotation.transpose() * (p.position - shift);
      inner += std::abs(x[0]) < 33 && std::abs(x[1]) < 19;
    }
    EXPECT_LE(inner, 1) << turn;
  }
}

TEST(SalientPoints, BytesDoNotDependOnThreads) {
  const Interior interior = rasterize(quadruped(), 96);
  const auto found_by = [&](int threads) {
    const ThreadLimit limit(threads);
    return find_salient_points(interior, {});
  };
  const auto one = found_by(1), two = found_by(2);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].position, two[i].position);
    EXPECT_EQ(one[i].radius, two[i].radius);
    EXPECT_EQ(one[i].response, two[i].response);
  }
}

TEST(SalientPoints, EmptyInteriorHasNone) { EXPECT_TRUE(find_salient_points({unit_grid(4), std::vector<float>(9 * 9 * 9)}, {}).empty()); }

}  // namespace
}  // namespace homolog
