// SPDX-License-Identifier: MIT
#include "homolog/match/local_map.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "fixtures/solids.h"

namespace homolog {
namespace {

std::vector<Vec3> some_points() {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) points.push_back(fixtures::random_rotation(i) * Vec3(1, 0.2 * i, 0));
  return points;
}

std::vector<Vec3> moved(std::vector<Vec3> points) {
  for (Vec3& x : points) x = 2 * fixtures::random_rotation(77) * Vec3(x.x(), x.y() + 0.2 * x.x() * x.x(), x.z());
  return points;
}

TEST(LocalMap, IsTheLimitOfDifferences) {
  const std::vector<Vec3> sources = some_points();
  const SourceSystem system(sources, std::vector<double>(sources.size(), 0.01));
  const ThinPlateSpline splines[] = {ThinPlateSpline::similarity_free(system, moved(sources), Chirality::proper),
                                     ThinPlateSpline::affine_free(sources, moved(sources))};
  const Vec3 x(0.3, -0.2, 0.5);
  for (const ThinPlateSpline& spline : splines) {
    Mat3 differences;
    for (int k = 0; k < 3; ++k) differences.col(k) = (spline(x + 1e-5 * Vec3::Unit(k)) - spline(x - 1e-5 * Vec3::Unit(k))) / 2e-5;
    EXPECT_TRUE(local_map(spline, x).gradient.isApprox(differences, 1e-7));
    EXPECT_TRUE(local_map(spline, x).position.isApprox(spline(x), 1e-12));
    EXPECT_TRUE(local_map(spline, sources[2]).gradient.allFinite());
  }
}

TEST(LocalMaps, AreWhatEachAloneIsToTheLastBit) {
  const std::vector<Vec3> sources = some_points();
  const SourceSystem system(sources, std::vector<double>(sources.size(), 0.01));
  const ThinPlateSpline splines[] = {ThinPlateSpline::similarity_free(system, moved(sources), Chirality::proper),
                                     ThinPlateSpline::affine_free(sources, moved(sources))};
  std::vector<Vec3> places = moved(sources);
  places.push_back(sources[2]);
  for (const ThinPlateSpline& spline : splines) {
    const std::vector<LocalMap> maps = local_maps(spline, places);
    ASSERT_EQ(maps.size(), places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_EQ(maps[i].position, local_map(spline, places[i]).position);
      EXPECT_EQ(maps[i].gradient, local_map(spline, places[i]).gradient);
    }
  }
  EXPECT_TRUE(local_maps(splines[0], {}).empty());
}

TEST(MappedNormal, StaysAcrossTheSurfaceAndOutward) {
  Mat3 stretch = Vec3(3, 1, 0.5).asDiagonal();
  const Mat3 gradients[] = {fixtures::random_rotation(3) * stretch, fixtures::random_rotation(4) * fixtures::mirror_x() * stretch};
  const Vec3 normal = Vec3(1, 2, -1).normalized(), along = normal.unitOrthogonal(), inward = -normal;
  for (const Mat3& J : gradients) {
    const Vec3 mapped = mapped_normal(J, normal);
    EXPECT_NEAR(mapped.norm(), 1, 1e-12);
    EXPECT_NEAR(mapped.dot(J * along), 0, 1e-12);
    EXPECT_LT(mapped.dot(J * inward), 0);
  }
}

}  // namespace
}  // namespace homolog
