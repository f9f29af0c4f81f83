// SPDX-License-Identifier: MIT
// Four nodes at once and by small turns, against one node after the other by its singular values.
#include "homolog/match/local_frames.h"

#include <gtest/gtest.h>

#include "homolog/describe/edges.h"
#include "match/synthetic_pairs.h"

namespace homolog {
namespace {

using Neighbours = std::vector<std::vector<int>>;

/// A chain of neighbourhoods, some of them nearly flat; the last node has none.
Neighbours neighbours_of(int count) {
  Neighbours neighbours(count);
  for (int i = 0; i + 1 < count; ++i) {
    for (int k = 1; k <= 6 + i % 4; ++k) neighbours[i].push_back((i + k) % (count - 1));
  }
  return neighbours;
}

/// Turned, sheared and shaken, all of it as large as the scale.
Cloth laid(const std::vector<Vec3>& rest, const Similarity& map, double shake) {
  std::mt19937 random(11);
  const auto some = [&] { return Vec3(2 * synthetic::in_cube(random) - Vec3::Ones()); };
  Cloth cloth;
  cloth.scale = map.scale;
  for (const Vec3& x : rest) {
    const Vec3 bent = Eigen::AngleAxisd(0.5 * x.z(), Vec3(1, 1, 0).normalized()) * Vec3(1.3 * x.x(), x.y() + 0.2 * x.x(), x.z());
    cloth.nodes.push_back(map(bent + shake * some()));
    cloth.rest.push_back(map.scale * (Mat3::Identity() + 0.1 * Mat3(some().asDiagonal())));
  }
  cloth.chirality = map.rotation.determinant() > 0 ? Chirality::proper : Chirality::mirrored;
  cloth.rotations.assign(rest.size(), map.rotation);
  cloth.scales.assign(rest.size(), map.scale);
  cloth.frames.assign(rest.size(), Mat3::Zero());
  return cloth;
}

/// The formulas of local_frames.h and edges.h, node by node.
Cloth one_by_one(Cloth cloth, const std::vector<Vec3>& rest, const Neighbours& neighbours) {
  std::vector<Mat3> stretch = cloth.rest;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    Mat3 covariance = Mat3::Zero(), squares = Mat3::Zero();
    double image_square = 0;
    for (const int j : neighbours[i]) {
      const Vec3 edge = rest[j] - rest[i], image = cloth.nodes[j] - cloth.nodes[i];
      covariance += image * edge.transpose();
      squares += edge * edge.transpose();
      image_square += image.squaredNorm();
    }
    if (neighbours[i].empty()) continue;
    const double square = squares.trace();
    cloth.rotations[i] = nearest_turn(covariance, cloth.chirality).rotation;
    const double measured = std::clamp(std::sqrt(image_square / square), cloth.scale / 4, cloth.scale * 4);
    cloth.scales[i] = std::sqrt(measured * cloth.scale);
    const Mat3 across = flat_share * square * Mat3::Identity();
    const Mat3 gradient = (cloth.rotations[i].transpose() * covariance + cloth.scale * across) * (squares + across).inverse();
    stretch[i] = (cloth.rest[i] + (gradient + gradient.transpose()) / 2) / 2;
  }
  for (std::size_t i = 0; i < rest.size(); ++i) {
    Mat3 sum = stretch[i];
    for (const int j : neighbours[i]) sum += stretch[j];
    cloth.frames[i] = cloth.rotations[i] * sum / (1.0 + static_cast<double>(neighbours[i].size()));
  }
  return cloth;
}

TEST(LocalFrames, AreThoseOfSingularValues) {
  std::vector<Vec3> rest = synthetic::points_in_cube(23, 5);             // no multiple of four
  for (std::size_t i = 8; i < 16; ++i) rest[i].z() = 0.3 * rest[i].x();  // on a plane
  const Neighbours neighbours = neighbours_of(23);
  const Edges edges = edges_of(rest, neighbours);
  for (const auto chirality : {Chirality::proper, Chirality::mirrored}) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
      Cloth cloth = laid(rest, synthetic::similarity(chirality, scale), 0.05);
      const Cloth expected = one_by_one(cloth, rest, neighbours);
      for (int call = 0; call < 1000; ++call) fit_local_frames(cloth, edges);  // each turns on from where the last one stopped
      for (std::size_t i = 0; i < rest.size(); ++i) {
        EXPECT_LT((cloth.rotations[i] - expected.rotations[i]).norm(), 1e-6) << i;
        EXPECT_NEAR(cloth.scales[i], expected.scales[i], 1e-9 * scale) << i;
        EXPECT_LT((cloth.frames[i] - expected.frames[i]).norm(), 1e-6 * scale) << i;
      }
    }
  }
}

TEST(LocalFrames, CollapsedNeighbourhoodsKeepTheirTurn) {
  const std::vector<Vec3> rest = synthetic::points_in_cube(23, 5);
  const Neighbours neighbours = neighbours_of(23);
  Cloth cloth = laid(rest, synthetic::similarity(Chirality::proper, 2), 0);
  const std::vector<Mat3> before = cloth.rotations;
  cloth.nodes.assign(rest.size(), Vec3(1, 2, 3));
  fit_local_frames(cloth, edges_of(rest, neighbours));
  EXPECT_EQ(cloth.rotations, before);
}

}  // namespace
}  // namespace homolog
