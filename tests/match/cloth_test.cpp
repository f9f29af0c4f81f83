// SPDX-License-Identifier: MIT
// The cloth follows a known bend, keeps what already fits, and does not care where or how large the world is.
#include "homolog/match/cloth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fixtures/shapes.h"
#include "match/synthetic_pairs.h"

namespace homolog {
namespace {

constexpr ClothSchedule schedule{16, 0.06, 0.015, 2, 0.2};  // as refine.cpp draws first
using Map = std::function<Vec3(const Vec3&)>;

ThinPlateSpline spline_of(const Similarity& map) {
  ThinPlateSpline spline;
  spline.similarity = map;
  spline.affine << map.scale * map.rotation, map.shift;
  return spline;
}

// The hand's skin carried by a map, normals by its differential.
std::vector<SurfaceSample> carried(const Map& map, double sign = 1) {
  std::vector<SurfaceSample> samples;
  for (std::size_t i = 0; i < 400; ++i) {
    const auto& [x, n] = fixtures::described_hand().surface[i];
    const Vec3 u = n.unitOrthogonal(), v = n.cross(u);
    const double h = 1e-5;
    const Vec3 normal = sign * (map(x + h * u) - map(x - h * u)).cross(map(x + h * v) - map(x - h * v));
    samples.push_back({map(x), normal.normalized()});
  }
  return samples;
}

double mean_error(const Cloth& cloth, const Map& truth) {
  double sum = 0;
  for (std::size_t i = 0; i < cloth.nodes.size(); ++i) sum += (cloth.nodes[i] - truth(fixtures::described_hand().body.nodes[i])).norm();
  return sum / static_cast<double>(cloth.nodes.size());
}

// About the x axis by an angle that grows with height: fingers curl to the front.
Vec3 curl(const Vec3& x) { return Eigen::AngleAxisd(0.35 * (x.y() + 0.9), Vec3::UnitX()) * x; }

TEST(Cloth, LiesWhereTheSplineSays) {
  const Similarity map = synthetic::similarity(Chirality::mirrored, 3);
  const Cloth cloth = lay_cloth(fixtures::described_hand().body, spline_of(map), Chirality::mirrored);
  EXPECT_LT(mean_error(cloth, map), 1e-12);
  for (std::size_t i = 0; i < cloth.nodes.size(); ++i) {
    EXPECT_LT((cloth.rotations[i] - map.rotation).norm(), 1e-4);  // turning stops at 1e-5 radians
    EXPECT_NEAR(cloth.scales[i], 3, 1e-9);
  }
}

TEST(Cloth, AnExactStartStays) {
  const Map identity = [](const Vec3& x) { return x; };
  Cloth cloth = lay_cloth(fixtures::described_hand().body, {}, Chirality::proper);
  draw_cloth(cloth, fixtures::described_hand().body, carried(identity), fixtures::described_hand().diagonal, {}, schedule);
  EXPECT_LT(mean_error(cloth, identity), 0.01 * fixtures::described_hand().body.spacing);  // what soft assignment shrinks is given back
}

TEST(Cloth, FollowsABendAndATurn) {
  const Mat3 turn = Eigen::AngleAxisd(0.15, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Map truth = [&](const Vec3& x) -> Vec3 { return turn * curl(x) + Vec3(0.03, 0, 0); };
  Cloth cloth = lay_cloth(fixtures::described_hand().body, {}, Chirality::proper);
  const double before = mean_error(cloth, truth);
  draw_cloth(cloth, fixtures::described_hand().body, carried(truth), fixtures::described_hand().diagonal, {}, schedule);
  EXPECT_GT(before, 2 * fixtures::described_hand().body.spacing);  // worth following
  EXPECT_LT(mean_error(cloth, truth), 0.25 * before);
}

TEST(Cloth, AnchorsHoldWhatTheSkinAloneWouldLose) {
  const Map truth = [](const Vec3& x) -> Vec3 { return Eigen::AngleAxisd(1.2, Vec3::UnitZ()) * x; };
  std::vector<Anchor> anchors;
  for (std::size_t p = 0; p < fixtures::described_hand().points.size(); ++p)
    anchors.push_back({fixtures::described_hand().body.point_node(p), truth(fixtures::described_hand().points[p].position)});
  Cloth lost = lay_cloth(fixtures::described_hand().body, {}, Chirality::proper), held = lost;
  draw_cloth(lost, fixtures::described_hand().body, carried(truth), fixtures::described_hand().diagonal, {}, schedule);
  draw_cloth(held, fixtures::described_hand().body, carried(truth), fixtures::described_hand().diagonal, anchors, schedule);
  EXPECT_LT(mean_error(held, truth), 0.5 * mean_error(lost, truth));  // a turn of 70 degrees, and no anchors but at the points
}

TEST(Cloth, LocalFramesKeepTheChirality) {
  const Mat3 mirror = fixtures::mirror_x();
  const Map truth = [&](const Vec3& x) -> Vec3 { return mirror * curl(x); };
  Cloth cloth = lay_cloth(fixtures::described_hand().body, spline_of({1, mirror, Vec3::Zero()}), Chirality::mirrored);
  const double before = mean_error(cloth, truth);
  draw_cloth(cloth, fixtures::described_hand().body, carried(truth, -1), fixtures::described_hand().diagonal, {}, schedule);
  EXPECT_LT(mean_error(cloth, truth), 0.4 * before);
  for (const Mat3& rotation : cloth.rotations) {
    EXPECT_NEAR(rotation.determinant(), -1, 1e-9);
    EXPECT_LT((rotation * rotation.transpose() - Mat3::Identity()).norm(), 1e-9);
  }
}

TEST(Cloth, PlaceAndSizeOfTheWorldDoNotMatter) {
  Cloth here = lay_cloth(fixtures::described_hand().body, {}, Chirality::proper);
  draw_cloth(here, fixtures::described_hand().body, carried(curl), fixtures::described_hand().diagonal, {}, schedule);
  for (const double scale : {1e-3, 1e3}) {
    const Similarity away{scale, Mat3::Identity(), scale * Vec3(1e4, -2e4, 500)};
    Cloth there = lay_cloth(fixtures::described_hand().body, spline_of(away), Chirality::proper);
    std::vector<SurfaceSample> samples = carried(curl);
    for (SurfaceSample& s : samples) s.position = away(s.position);
    draw_cloth(there, fixtures::described_hand().body, samples, scale * fixtures::described_hand().diagonal, {}, schedule);
    double worst = 0;
    for (std::size_t i = 0; i < here.nodes.size(); ++i) worst = std::max(worst, (there.nodes[i] - away(here.nodes[i])).norm() / scale);
    EXPECT_LT(worst, 1e-3 * fixtures::described_hand().diagonal) << scale;  // weights are single precision, over 16 rounds
  }
}

}  // namespace
}  // namespace homolog
