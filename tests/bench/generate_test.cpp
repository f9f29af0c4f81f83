// SPDX-License-Identifier: MIT
// Generated cases: closed meshes, exact truths, and the count of instances in scenes.
#include "generate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "change_mesh.h"
#include "cut_mesh.h"
#include "fixtures/solids.h"
#include "homolog/base/errors.h"
#include "instances.h"
#include "scene.h"

namespace homolog::bench {
namespace {

Mesh quadruped() { return mesh_of(fixtures::quadruped(), 40); }

TEST(CutMesh, PartIsClosedAndHasItsShare) {
  const Mesh whole = quadruped();
  for (const double share : {0.1, 0.5, 0.6}) {
    const CutPart part = cut_share(whole, Vec3(1, 0.3, -0.2).normalized(), share);
    EXPECT_TRUE(is_closed(part.mesh));
    EXPECT_NEAR(volume_of(part.mesh) / volume_of(whole), share, 1e-4);
    for (std::size_t i = 0; i < part.whole_vertex.size(); ++i) {
      EXPECT_EQ(part.mesh.vertices[i], whole.vertices[static_cast<std::size_t>(part.whole_vertex[i])]);
    }
  }
}

TEST(ChangeMesh, BendingKeepsVolumeAndLocalShape) {
  const Mesh whole = quadruped();
  const double volume = volume_of(whole);
  EXPECT_NEAR(volume_of(bent(whole, 60)) / volume, 1, 0.12);
  EXPECT_NEAR(volume_of(twisted(whole, 60)) / volume, 1, 0.02);
  EXPECT_NEAR(volume_of(mirrored(whole)) / volume, 1, 1e-9);
  EXPECT_GT(volume_of(fattened(whole, 1.5)) / volume, 1.3);
  EXPECT_GT(bounding_box(lengthened(whole, 0.6, 1.6)).diagonal(), 1.1 * bounding_box(whole).diagonal());
}

TEST(ChangeMesh, ClusteringIsCoarserAndClosed) {
  const Mesh whole = quadruped(), coarse = clustered(whole, 24);
  EXPECT_LT(coarse.vertices.size(), whole.vertices.size() / 2);
  EXPECT_TRUE(is_closed(coarse));
  EXPECT_NEAR(volume_of(coarse) / volume_of(whole), 1, 0.1);
}

TEST(Scene, CopiesLieApartAndVolumesAddUp) {
  const Mesh shape = quadruped();
  const Scene scene = make_scene(shape, {shape}, {.copies = 3, .largest_ratio = 2, .mirror = true}, 1);
  ASSERT_EQ(scene.copies.size(), 3u);
  EXPECT_TRUE(scene.copies[1].mirrored);
  const double expected = 1.0 / 8 + 1 + 8 + 0.216;
  EXPECT_NEAR(volume_of(scene.mesh) / volume_of(shape), expected, 1e-6);
}

// An oracle: points all over the model, carried by the truth itself.
Family oracle(const std::vector<Truth>& truths, const Points& model, double confidence) {
  Family family;
  for (const Truth& truth : truths) {
    Match match;
    match.confidence = confidence;
    for (std::size_t i = 0; i < model.size(); ++i) {
      const auto placed = carry(truth.direct, model[i].position, model[i].radius);
      const int k = static_cast<int>(i);
      match.pairs.push_back({.model = k, .data = k, .model_point = model[i], .data_point = {.position = placed->position, .radius = 0.01}});
    }
    family.matches.push_back(match);
  }
  return family;
}

Points some_points(const Mesh& mesh) {
  Points points;
  for (std::size_t i = 0; i < mesh.vertices.size(); i += mesh.vertices.size() / 12)
    points.push_back({.position = mesh.vertices[i], .radius = 0.05});
  return points;
}

TEST(GeneratedCases, AnOracleIsRightOnAllOfThem) {
  const NamedMesh shape{"quadruped", quadruped()}, stranger{"box", mesh_of(fixtures::box({0, 0, 0}, {0.2, 0.5, 1}), 20)};
  const std::vector<Case> cases = generated_cases({shape}, {stranger}, 1);
  int scenes = 0, parts = 0, strangers = 0;
  for (const Case& one : cases) {
    const Mesh model = one.model.read(), data = one.data.read();
    std::vector<Truth> truths;
    for (const TruePoints& points : one.truths(model, data)) truths.push_back(make_truth(points));
    strangers += truths.empty();
    if (truths.empty()) continue;
    const Points points = some_points(model);
    const PairScore score = score_instances(oracle(truths, points, 0.9), points, {}, truths, bounding_box(data).diagonal());
    EXPECT_TRUE(score.success_direct) << one.pair.model;
    EXPECT_EQ(score.instances_right, score.instances) << one.pair.model;
    EXPECT_EQ(instance_f1(score), 1) << one.pair.model;
    scenes += score.instances > 1;
    parts += one.pair.task == "part";
  }
  EXPECT_EQ(scenes, 3);
  EXPECT_EQ(parts, 4);
  EXPECT_EQ(strangers, 1);
}

TEST(GeneratedCases, HoldRemeshedWholesAndPartsOfATenth) {
  const Mesh whole = quadruped();
  int remeshed = 0, tenths = 0;
  for (const Case& one : generated_cases({{"quadruped", whole}}, {}, 1)) {
    if (one.pair.model == "remeshed/quadruped") {
      const Mesh data = one.data.read();
      EXPECT_TRUE(is_closed(data));
      EXPECT_GT(data.vertices.size(), 2 * whole.vertices.size());
      EXPECT_NEAR(volume_of(data) / volume_of(whole), 1, 0.01);
      EXPECT_EQ(one.truths(whole, data)[0].data, whole.vertices);
      ++remeshed;
    }
    if (one.pair.model != "part10/quadruped") continue;
    EXPECT_NEAR(volume_of(one.model.read()) / volume_of(whole), 0.1, 1e-4);
    ++tenths;
  }
  EXPECT_EQ(remeshed, 1);
  EXPECT_EQ(tenths, 1);
}

TEST(GeneratedCases, RefuseOpenMeshesAndEqualNamesAndTurnOverWhatIsInsideOut) {
  const Mesh whole = quadruped();
  Mesh open = whole, inside_out = whole;
  open.triangles.pop_back();
  EXPECT_THROW(generated_cases({{"a", open}}, {}, 1), ShapeError);
  EXPECT_THROW(generated_cases({{"a", whole}, {"a", whole}}, {}, 1), ParamError);
  EXPECT_THROW(generated_cases({{"heap1", whole}}, {{"heap1", whole}}, 1), ParamError);
  turn_over(inside_out.triangles);
  const auto right = generated_cases({{"a", whole}}, {}, 1), turned = generated_cases({{"a", inside_out}}, {}, 1);
  for (std::size_t i = 0; i < right.size(); ++i) {
    EXPECT_EQ(turned[i].model.read().vertices, right[i].model.read().vertices) << right[i].pair.model;
    EXPECT_GT(volume_of(turned[i].data.read()), 0) << right[i].pair.model;
  }
}

TEST(Instances, MissedRepeatedAndWrongOnesLowerF1) {
  const Mesh shape = quadruped();
  const Scene scene = make_scene(shape, {}, {.copies = 2}, 3);
  std::vector<Truth> truths;
  for (const auto& copy : scene.copies) {
    TruePoints points;
    points.model = shape.vertices;
    const auto first = scene.mesh.vertices.begin() + static_cast<long>(copy.first_vertex);
    points.data.assign(first, first + static_cast<long>(shape.vertices.size()));
    truths.push_back(make_truth(points));
  }
  const Points points = some_points(shape);
  const double diagonal = bounding_box(scene.mesh).diagonal();
  const auto f1 = [&](const Family& family) { return instance_f1(score_instances(family, points, {}, truths, diagonal)); };
  const Family both = oracle(truths, points, 0.9);
  EXPECT_EQ(f1(both), 1);
  EXPECT_EQ(f1({}), 0);
  EXPECT_EQ(f1(oracle(truths, points, 0.4)), 0);
  EXPECT_NEAR(f1({{both.matches[0]}, {}}), 2.0 / 3, 1e-12);
  EXPECT_NEAR(f1({{both.matches[0], both.matches[0]}, {}}), 0.5, 1e-12);
  Match wrong = both.matches[0];
  for (auto& pair : wrong.pairs) pair.data_point.position += Vec3(diagonal, 0, 0);
  EXPECT_NEAR(f1({{both.matches[0], both.matches[1], wrong}, {}}), 0.8, 1e-12);
  Match near = both.matches[0];  // 10 % of the copy off, which is less than 5 % of the scene
  for (auto& pair : near.pairs) pair.data_point.position += Vec3(0.1 * bounding_box(shape).diagonal(), 0, 0);
  EXPECT_EQ(f1({{near}, {}}), 0);
}

TEST(Unrelated, AClaimIsAFailure) {
  Match match;
  match.confidence = 0.3;
  EXPECT_TRUE(score_unrelated({{match}, {}}, {}, {}).success);
  EXPECT_TRUE(score_unrelated({}, {}, {}).success);
  match.confidence = 0.6;
  EXPECT_FALSE(score_unrelated({{match}, {}}, {}, {}).success);
}

}  // namespace
}  // namespace homolog::bench
