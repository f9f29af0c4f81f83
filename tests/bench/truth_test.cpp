// SPDX-License-Identifier: MIT
// The bench's truth: where it carries points, and how far it dares.
#include "truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mirror_symmetry.h"
#include "surface_distance.h"

namespace homolog::bench {
namespace {

std::vector<Vec3> cloud(int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.emplace_back(unit(random), 0.5 * unit(random), 0.2 * unit(random));
  return points;
}

std::vector<Vec3> moved_by(const Similarity& map, std::vector<Vec3> points) {
  for (Vec3& p : points) p = map(p);
  return points;
}

TEST(Truth, SimilarityAndReflectionAreCarriedExactly) {
  const auto model = cloud(200);
  Similarity map = random_similarity(1, "a", 1);
  for (const bool mirrored : {false, true}) {
    if (mirrored) map.rotation *= -1;
    for (const bool dense : {true, false}) {
      const Truth truth = make_truth(TruePoints{dense, mirrored, model, moved_by(map, model), {}});
      EXPECT_EQ(truth.direct.mirrored, mirrored);
      const Vec3 x(0.3, -0.1, 0.05);
      const auto placed = carry(truth.direct, x, 0.2);
      ASSERT_TRUE(placed);
      EXPECT_LT((placed->position - map(x)).norm() / map.scale, 1e-6);
      EXPECT_NEAR(placed->scale / map.scale, 1, 1e-6);
    }
  }
}

TEST(Truth, BentBodyIsCarriedLocally) {
  const auto model = cloud(2000);
  const auto bend = [](const Vec3& x) { return Vec3(std::sin(x.x()) * (1 - x.y()), 1 - std::cos(x.x()) * (1 - x.y()), x.z()); };
  std::vector<Vec3> data;
  for (const Vec3& x : model) data.push_back(bend(x));
  const Truth truth = make_truth({true, false, model, data, {}});
  EXPECT_FALSE(truth.direct.mirrored);
  EXPECT_LT((carry(truth.direct, {0.9, 0, 0}, 0.1)->position - bend({0.9, 0, 0})).norm(), 0.02);
}

TEST(Truth, LandmarksDoNotPlaceWhatIsFarFromThem) {
  const auto model = cloud(20);
  const Truth truth = make_truth({false, false, model, model, {}});
  EXPECT_TRUE(carry(truth.direct, model[3] + Vec3(0.1, 0, 0), 0.1));
  EXPECT_FALSE(carry(truth.direct, {3, 0, 0}, 0.1));
}

TEST(Truth, TurnsDoNotChangeWhatLandmarksTell) {
  const auto model = cloud(20);
  auto data = model;
  for (Vec3& p : data) p.z() += 0.3 * std::sin(3 * p.x());
  const TruePoints points{false, false, model, data, {}};
  const Similarity a = random_similarity(1, "a", 1), b = random_similarity(1, "b", 1);
  const Truth plain = make_truth(points), turned = make_truth(points, a, b);
  for (const Vec3& x : cloud(300)) {
    const auto placed = carry(plain.direct, 1.3 * x, 0.1), again = carry(turned.direct, a(1.3 * x), 0.1 * a.scale);
    ASSERT_EQ(placed.has_value(), again.has_value());
    if (placed) EXPECT_LT((b(placed->position) - again->position).norm() / b.scale, 1e-6);
  }
}

TEST(Truth, RandomTurnsRepeatAndDiffer) {
  const Similarity a = random_similarity(1, "a", 1), again = random_similarity(1, "a", 1), b = random_similarity(1, "b", 1);
  EXPECT_EQ(a.rotation, again.rotation);
  EXPECT_NE(a.rotation, b.rotation);
  EXPECT_NEAR(a.rotation.determinant(), 1, 1e-12);
  EXPECT_TRUE(a.scale >= 1e-3 && a.scale <= 1e3);
}

TEST(MirrorSymmetry, IsFoundOnlyWhereItIs) {
  auto points = cloud(100);
  for (int i = 0; i < 100; ++i) points.push_back(points[static_cast<std::size_t>(i)].cwiseProduct(Vec3(1, -1, 1)));
  const auto swap = mirror_symmetry(points, points.size());
  ASSERT_EQ(swap.size(), 200u);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(swap[static_cast<std::size_t>(i)], i + 100);
  EXPECT_TRUE(mirror_symmetry(cloud(200), 200).empty());
}

TEST(SurfaceDistance, ReachesFacesEdgesAndCorners) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_NEAR(surface_distance(mesh, {0.2, 0.2, 0.5}), 0.5, 1e-12);
  EXPECT_NEAR(surface_distance(mesh, {0.5, -0.3, 0}), 0.3, 1e-12);
  EXPECT_NEAR(surface_distance(mesh, {2, 0, 0}), 1, 1e-12);
}

}  // namespace
}  // namespace homolog::bench
