// SPDX-License-Identifier: MIT
#include "homolog/match/coverage.h"

#include <gtest/gtest.h>

#include "fixtures/solids.h"
#include "homolog/shape/voxelize.h"

namespace homolog {
namespace {

constexpr int resolution = 48;

Shape shape_of(const Mesh& mesh, const std::optional<Box>& part = {}) {
  Shape shape;
  shape.interior = voxelize(mesh, resolution, part).interior;
  const GridFrame& frame = shape.interior.frame;
  shape.diagonal = frame.spacing * Vec3(frame.size[0], frame.size[1], frame.size[2]).norm();
  shape.surface = sample_surface(shape.interior, 300);
  return shape;
}

/// A match whose warp is exactly this similarity.
Match match_by(const fixtures::Similarity& similarity) {
  Match match;
  match.similarity = {similarity.scale, similarity.rotation, similarity.shift};
  match.data_from_model.affine.leftCols<3>() = similarity.scale * similarity.rotation;
  match.data_from_model.affine.col(3) = similarity.shift;
  return match;
}

Mesh moved(Mesh mesh, const fixtures::Similarity& similarity) {
  for (Vec3& v : mesh.vertices) v = similarity(v);
  return mesh;
}

MatchParts part_of(const Mesh& model, const Shape& model_shape, const Mesh& data, const fixtures::Similarity& similarity) {
  const Shape data_shape = shape_of(data);
  return covered_parts({model, model_shape}, {data, data_shape}, {match_by(similarity)}).front();
}

double least(const std::vector<float>& weights) { return *std::min_element(weights.begin(), weights.end()); }
double most(const std::vector<float>& weights) { return *std::max_element(weights.begin(), weights.end()); }

const fixtures::Similarity turn{fixtures::random_rotation(5), 3, {10, -20, 5}};

TEST(CoveredParts, AreAllOfAShapeFoundAgain) {
  const Mesh model = fixtures::mesh_of(fixtures::hand(), resolution);
  const MatchParts parts = part_of(model, shape_of(model), moved(model, turn), turn);
  for (const auto* weights : {&parts.model, &parts.data}) {
    EXPECT_EQ(least(weights->vertices), 1);
    EXPECT_GT(least(weights->samples), 0.5);
  }
}

TEST(CoveredParts, AreAllOfAMirrorImage) {
  const Mesh model = fixtures::mesh_of(fixtures::hand(), resolution);
  const fixtures::Similarity mirror{turn.rotation * fixtures::mirror_x(), turn.scale, turn.shift};
  const MatchParts parts = part_of(model, shape_of(model), moved(model, mirror), mirror);
  EXPECT_EQ(least(parts.model.vertices), 1);
  EXPECT_EQ(least(parts.data.vertices), 1);
}

TEST(CoveredParts, EndWithinAVoxelWhereThePartInUseEnds) {
  const Mesh model = fixtures::mesh_of(fixtures::quadruped(), resolution);
  const Box half{Vec3(0.5, 0, 0), Vec3(1, 1, 1)};
  const Shape shape = shape_of(model, half);
  const Box whole = bounding_box(model);
  const double border = (whole.min.x() + whole.max.x()) / 2, voxel = shape.interior.frame.spacing;
  const MatchParts parts = part_of(model, shape, moved(model, turn), turn);
  for (std::size_t i = 0; i < model.vertices.size(); ++i) {
    const double beyond = (border - model.vertices[i].x()) / voxel;
    if (std::abs(beyond) < 1) continue;
    EXPECT_EQ(parts.model.vertices[i], beyond < 0 ? 1 : 0) << beyond;
    EXPECT_EQ(parts.data.vertices[i], beyond < 0 ? 1 : 0) << beyond;
  }
  ASSERT_TRUE(parts.model.box);
  EXPECT_NEAR(parts.model.box->min.x(), border, voxel);
  EXPECT_NEAR(parts.model.box->max.x(), whole.max.x(), voxel);
  EXPECT_FALSE(parts.data.box) << "all of it was described";
}

TEST(CoveredParts, EndWithinAVoxelWhereAPieceIsCutOffAndLeaveTheCutOut) {
  const Mesh model = fixtures::mesh_of(fixtures::cylinder({0, 0, 0}, {1, 0, 0}, 0.3), resolution);
  const Mesh whole = fixtures::mesh_of(fixtures::cylinder({0, 0, 0}, {2, 0, 0}, 0.3), 2 * resolution);
  const Shape shape = shape_of(model);
  const MatchParts parts = part_of(model, shape, moved(whole, turn), turn);
  const double voxel = 2.0 / resolution;  // the coarser of the two: the data has the same number of voxels for twice the length
  for (std::size_t i = 0; i < whole.vertices.size(); ++i) {
    const double beyond = (whole.vertices[i].x() - 1) / voxel;
    if (beyond > 1.6) EXPECT_EQ(parts.data.vertices[i], 0) << beyond;
    if (beyond < -1) EXPECT_EQ(parts.data.vertices[i], 1) << beyond;
  }
  for (std::size_t i = 0; i < model.vertices.size(); ++i) {
    const Vec3& v = model.vertices[i];
    if (v.x() < 1 - voxel) EXPECT_EQ(parts.model.vertices[i], 1);
    if (v.x() > 1 - 1e-9 && v.tail<2>().norm() < 0.3 - voxel) EXPECT_EQ(parts.model.vertices[i], 0);
  }
}

TEST(CoveredParts, LeaveOutWhatTheDataHasNot) {
  const auto body = fixtures::ellipsoid({0, 0, 0}, {1, 0.6, 0.5});
  const Mesh data = fixtures::mesh_of(body, resolution);
  const Mesh model = fixtures::mesh_of(fixtures::join({body, fixtures::capsule({0.8, 0, 0}, {1.8, 0, 0}, 0.2)}), resolution);
  const MatchParts parts = part_of(model, shape_of(model), data, {});
  for (std::size_t i = 0; i < model.vertices.size(); ++i) {
    const double x = model.vertices[i].x();
    if (x > 1.15) EXPECT_EQ(parts.model.vertices[i], 0) << x;
    if (x < 0.8) EXPECT_GT(parts.model.vertices[i], 0.9) << x;
  }
}

TEST(CoveredParts, AreNothingOfAShapeElsewhere) {
  const Mesh model = fixtures::mesh_of(fixtures::hand(), resolution);
  const MatchParts parts = part_of(model, shape_of(model), moved(model, {Mat3::Identity(), 1, {9, 0, 0}}), {});
  EXPECT_EQ(most(parts.model.vertices), 0);
  EXPECT_EQ(most(parts.data.samples), 0);
}

double mean_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return sum / static_cast<double>(a.size());
}

struct ByBoth {
  MatchParts all, clusters;
};

/// Parts asked at all vertices of meshes finer than the voxels, and at their clusters.
ByBoth parts_by_both(const Mesh& model, const Shape& model_shape, const Mesh& data, const fixtures::Similarity& similarity) {
  const Shape data_shape = shape_of(data);
  const auto parts = [&](std::size_t most_asked) {
    return covered_parts({model, model_shape}, {data, data_shape}, {match_by(similarity)}, most_asked).front();
  };
  return {parts(model.vertices.size() + data.vertices.size()), parts(0)};
}

TEST(CoveredParts, AskedAtClustersAreAllOfAShapeFoundAgain) {
  const Mesh model = fixtures::mesh_of(fixtures::hand(), 3 * resolution);
  const MatchParts parts = parts_by_both(model, shape_of(model), moved(model, turn), turn).clusters;
  EXPECT_EQ(parts.model.vertices.size(), model.vertices.size());
  EXPECT_EQ(least(parts.model.vertices), 1);
  EXPECT_EQ(least(parts.data.vertices), 1);
}

TEST(CoveredParts, AskedAtClustersDifferFromThoseOfAllVerticesOnlyAtTheBorder) {
  const Mesh model = fixtures::mesh_of(fixtures::cylinder({0, 0, 0}, {1, 0, 0}, 0.3), 3 * resolution);
  const Mesh whole = fixtures::mesh_of(fixtures::cylinder({0, 0, 0}, {2, 0, 0}, 0.3), 6 * resolution);
  const auto [all, clusters] = parts_by_both(model, shape_of(model), moved(whole, turn), turn);
  const double voxel = 2.0 / resolution;
  for (std::size_t i = 0; i < whole.vertices.size(); ++i) {
    const double difference = std::abs(all.data.vertices[i] - clusters.data.vertices[i]);
    EXPECT_LT(difference, std::abs(whole.vertices[i].x() - 1) > 2 * voxel ? 1e-6 : 0.4) << whole.vertices[i].transpose() / voxel;
  }
  EXPECT_LT(mean_difference(all.data.vertices, clusters.data.vertices), 0.01);
  EXPECT_LT(mean_difference(all.model.vertices, clusters.model.vertices), 0.01);
  EXPECT_LT(mean_difference(all.data.samples, clusters.data.samples), 0.01);
}

TEST(CoveredParts, AskedAtClustersEndWhereThePartInUseEnds) {
  const Mesh model = fixtures::mesh_of(fixtures::quadruped(), 3 * resolution);
  const Shape shape = shape_of(model, Box{Vec3(0.5, 0, 0), Vec3(1, 1, 1)});
  const MatchParts parts = parts_by_both(model, shape, moved(model, turn), turn).clusters;
  const Box whole = bounding_box(model);
  const double border = (whole.min.x() + whole.max.x()) / 2, voxel = shape.interior.frame.spacing;
  for (std::size_t i = 0; i < model.vertices.size(); ++i) {
    const double beyond = (border - model.vertices[i].x()) / voxel;
    if (std::abs(beyond) > 2) EXPECT_EQ(parts.model.vertices[i], beyond < 0 ? 1 : 0) << beyond;
  }
}

TEST(CoveredParts, AreNoneWithoutMatches) {
  const Mesh model = fixtures::mesh_of(fixtures::hand(), resolution);
  const Shape shape = shape_of(model);
  EXPECT_TRUE(covered_parts({model, shape}, {model, shape}, {}).empty());
}

TEST(Fade, GoesFromOneToZero) {
  EXPECT_EQ(fade(0.3, 1, 2), 1);
  EXPECT_EQ(fade(1.5, 1, 2), 0.5);
  EXPECT_EQ(fade(2, 1, 2), 0);
}

}  // namespace
}  // namespace homolog
