// SPDX-License-Identifier: MIT
// The whole way: a shape finds itself moved, turned, scaled, remeshed and noisy; strangers are not found.
#include "homolog/homolog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "fixtures/shapes.h"
#include "homolog/outputs/match_json.h"

namespace homolog {
namespace {

using namespace fixtures;
using Move = fixtures::Similarity;

constexpr int voxels = 80;

const Mesh& hand_mesh() {
  static const Mesh mesh = mesh_of(hand(), voxels);
  return mesh;
}

Mesh moved_mesh(Mesh mesh, const Move& move) {
  for (Vec3& v : mesh.vertices) v = move(v);
  if (move.rotation.determinant() < 0) {
    for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  }
  return mesh;
}

// Bent sideways towards its fingertips.
Mesh bent_hand_mesh() {
  Mesh mesh = hand_mesh();
  for (Vec3& v : mesh.vertices) v.x() += 0.1 * v.y() * v.y();
  return mesh;
}

// How far the warp is from the truth at the model's points, in data diagonals.
double error_of(const Match& match, const Shape& model, const Shape& data, const Move& truth) {
  double sum = 0;
  for (const SalientPoint& p : model.points) sum += (match.data_from_model(p.position) - truth(p.position)).norm();
  return sum / static_cast<double>(model.points.size()) / data.diagonal;
}

// Two percent of the diagonal: a voxel or two, since places are as good as the voxels.
constexpr double right = 0.02;

void expect_found(const Mesh& mesh, const Mesh& copy, const Move& truth, const std::string& what, int resolution = voxels) {
  const Shape model = describe_shape(mesh, coarse(resolution)), data = describe_shape(copy, coarse(resolution));
  const Family family = match_shapes(model, data, coarse(resolution));
  ASSERT_FALSE(family.matches.empty()) << what;
  const Match& best = family.matches[0];
  EXPECT_LT(error_of(best, model, data, truth), right) << what;
  EXPECT_GT(best.confidence, 0.5) << what;
  EXPECT_GT(best.similarity.rotation.determinant() * truth.rotation.determinant(), 0) << what;
}

TEST(WholeWay, AHandFindsItselfMovedTurnedAndScaled) {
  const Move move{random_rotation(1), 1e-3, {5, -3, 2}};
  expect_found(hand_mesh(), moved_mesh(hand_mesh(), move), move, "small copy");
}

TEST(WholeWay, AHandFindsItselfRemeshedAndLarge) {
  const Move move{random_rotation(2), 1e3, {-7e3, 1e4, 2}};
  expect_found(hand_mesh(), moved_mesh(mesh_of(hand(), 50), move), move, "large copy of a coarser mesh");
}

TEST(WholeWay, ATurnedHandIsToldProper) {
  const Move move{random_rotation(2), 1e3, {-7e3, 1e4, 2}};
  const Shape model = describe_shape(hand_mesh(), coarse(voxels));
  const Family family = match_shapes(model, describe_shape(moved_mesh(hand_mesh(), move), coarse(voxels)), coarse(voxels));
  ASSERT_FALSE(family.matches.empty());
  EXPECT_EQ(family.matches[0].handedness, Handedness::proper);
}

TEST(WholeWay, TheScaleOfARigidCopyIsRightWithinOnePercent) {
  const Move move{random_rotation(1), 1e-3, {5, -3, 2}};
  const Shape model = describe_shape(hand_mesh(), coarse(voxels));
  const Shape data = describe_shape(moved_mesh(hand_mesh(), move), coarse(voxels));
  const Family family = match_shapes(model, data, coarse(voxels));
  ASSERT_FALSE(family.matches.empty());
  EXPECT_NEAR(family.matches[0].similarity.scale / move.scale, 1, 0.01);
}

TEST(WholeWay, HoweverAShapeIsTurnedItsPointsAndPairsAreTheSame) {
  const Mesh bent = bent_hand_mesh();
  const Shape model = describe_shape(hand_mesh(), coarse(voxels)), data = describe_shape(bent, coarse(voxels));
  const Family family = match_shapes(model, data, coarse(voxels));
  ASSERT_FALSE(family.matches.empty());
  for (const int seed : {1, 2, 3}) {
    const Move move{random_rotation(seed), std::pow(30.0, seed - 2), {5, -3, 2.0 * seed}};
    const Shape turned = describe_shape(moved_mesh(bent, move), coarse(voxels));
    ASSERT_EQ(turned.points.size(), data.points.size());
    for (std::size_t i = 0; i < data.points.size(); ++i) {
      EXPECT_LT((turned.points[i].position - move(data.points[i].position)).norm(), 1e-4 * turned.diagonal);
      EXPECT_NEAR(turned.points[i].radius / (move.scale * data.points[i].radius), 1, 1e-4);
    }
    const Family again = match_shapes(model, turned, coarse(voxels));
    ASSERT_FALSE(again.matches.empty());
    const auto numbers = [](const Match& match) {
      std::vector<std::pair<int, int>> pairs;
      for (const Correspondence& c : match.pairs) pairs.emplace_back(c.model, c.data);
      return pairs;
    };
    EXPECT_EQ(numbers(again.matches[0]), numbers(family.matches[0])) << seed;
    EXPECT_NEAR(again.matches[0].confidence, family.matches[0].confidence, 1e-3);
  }
}

TEST(WholeWay, AHandFindsItselfInNoise) {
  Mesh noisy = hand_mesh();
  std::mt19937 random(4);
  const double amplitude = 0.004 * bounding_box(noisy).diagonal();
  for (Vec3& v : noisy.vertices) {
    for (int a = 0; a < 3; ++a) v[a] += amplitude * (2.0 * random() / std::mt19937::max() - 1);
  }
  expect_found(hand_mesh(), noisy, {}, "noise");
}

// The hand is flat: at 80 voxels its mirror image is not more like it than the mirrored match's handicap in merit (evidence.cpp).
// Of three sizes, one beside the other.
TEST(WholeWay, EveryCopyOfAHandIsFound) {
  constexpr int fine = 160;  // the smallest is a third of the scene
  const Move places[] = {{random_rotation(6), 1, {0, 0, 0}}, {random_rotation(7), 0.7, {2.5, 0, 0}}, {random_rotation(8), 1.3, {0, 3, 0}}};
  Solid hands;
  for (const Move& place : places) hands = join({hands, moved(hand(), place)});
  const Shape model = describe_shape(hand_mesh(), coarse(voxels)), scene = described(hands, fine);
  const Family family = match_shapes(model, scene, coarse(fine));
  for (const Move& place : places) {
    const auto found = std::count_if(family.matches.begin(), family.matches.end(), [&](const Match& match) {
      return match.confidence > 0.5 && error_of(match, model, scene, place) < right * place.scale * model.diagonal / scene.diagonal;
    });
    EXPECT_EQ(found, 1) << "the copy of scale " << place.scale;
  }
}

TEST(WholeWay, AMirroredHandIsFoundMirrored) {
  const Move mirror{mirror_x(), 1, {1, 0, 0}};
  expect_found(hand_mesh(), moved_mesh(hand_mesh(), mirror), mirror, "mirror", 128);
}

// Mirror::only is left to Family.MirrorParameterLeavesOneChirality.
TEST(WholeWay, ForbiddenMirrorImagesAreNotTold) {
  const Shape shape = described(hand());
  Params params = coarse();
  params.match.mirror = Mirror::forbid;
  const Family family = match_shapes(shape, described(moved(hand(), {mirror_x(), 1, {1, 0, 0}})), params);
  for (const Match& match : family.matches) EXPECT_GT(match.similarity.rotation.determinant(), 0);
}

TEST(WholeWay, StrangersAreNotFound) {
  const Shape ring = described(torus({0, 0, 0}, {0, 0, 1}, 1, 0.25)), five = described(hand());
  for (const auto& [model, data] : {std::pair(&ring, &five), std::pair(&five, &ring)}) {
    for (const Match& match : match_shapes(*model, *data, coarse()).matches) EXPECT_LT(match.confidence, 0.5);
  }
}

TEST(WholeWay, AQuadrupedsSymmetryIsItsMirrorImageAndNotTheIdentity) {
  const Shape shape = described(quadruped(), voxels);
  const Family family = find_symmetries(shape, coarse(voxels));
  ASSERT_FALSE(family.matches.empty());
  const Move mirror{Vec3(1, -1, 1).asDiagonal().toDenseMatrix(), 1, Vec3::Zero()};
  EXPECT_LT(error_of(family.matches[0], shape, shape, mirror), right);
  EXPECT_GT(family.matches[0].confidence, 0.5);
  for (const Match& match : family.matches) EXPECT_GT(error_of(match, shape, shape, {}), right);
}

// A hook with a short and a long arm, standing at `place`, `size` times as large and turned by `angle` about x.
Solid hook(const Vec3& place, double size, double angle) {
  const auto at = [&](double x, double y, double z) -> Vec3 {
    return place + size * (Eigen::AngleAxisd(angle, Vec3::UnitX()) * Vec3(x, y, z));
  };
  return join({capsule(at(0, 0, 0), at(0, 0, 2), 0.25 * size), capsule(at(0, 0, 2), at(0.8, 0, 2), 0.25 * size),
               capsule(at(0, 0, 0), at(0, 1.2, 0), 0.25 * size)});
}

TEST(WholeWay, ARepeatedPieceIsToldWithItsMovements) {
  const Vec3 large(0, 6, 0), first(0, 0, 0), second(4, 0, 0);
  const Shape shape = described(join({hook(first, 1, 0), hook(second, 1, 0), hook(large, 1.5, 1)}), voxels);
  const Family family = find_symmetries(shape, coarse(voxels));
  int on_first = 0, on_second = 0;
  for (const Match& match : family.matches) {
    if (match.confidence < 0.5 || match.handedness == Handedness::mirrored) continue;
    on_first += (match.similarity(large) - first).norm() < 0.2;
    on_second += (match.similarity(large) - second).norm() < 0.2;
    for (const Correspondence& c : match.pairs) {
      EXPECT_EQ(c.model_point.position, shape.points[c.model].position);
      EXPECT_LT(c.data, static_cast<int>(shape.points.size() + family.followed.size()));
    }
  }
  EXPECT_EQ(on_first, 1);
  EXPECT_EQ(on_second, 1);
}

TEST(WholeWay, BytesRepeatForAnyNumberOfThreads) {
  std::string first;
  for (const int threads : {1, 3}) {
    Params params = coarse();
    params.threads = threads;
    const Shape model = describe_shape(hand_mesh(), params);
    const Shape data = describe_shape(moved_mesh(hand_mesh(), {random_rotation(3), 2, {1, 2, 3}}), params);
    const std::string text = match_json(model, data, match_shapes(model, data, params), params);
    if (first.empty()) first = text;
    EXPECT_TRUE(text == first) << threads << " threads";  // not EXPECT_EQ, which would print megabytes
  }
}

TEST(WholeWay, EveryParameterOutOfRangeIsRefused) {
  const Shape shape = described(ball({0, 0, 0}, 1), 32);
  Params params;
  const auto refused = [&] {
    EXPECT_THROW(describe_shape(hand_mesh(), params), ParamError);
    EXPECT_THROW(match_shapes(shape, shape, params), ParamError);
    EXPECT_THROW(find_symmetries(shape, params), ParamError);
    params = {};
  };
  params.voxel.resolution = 31;
  refused();
  params.salient.sigma0 = -1;
  refused();
  params.descriptor.degree = 17;
  refused();
  params.match.bending = NAN;
  refused();
  params.match.partners = 0;
  refused();
  params.paper.chamfer_limit = INFINITY;
  refused();
}

// Fig. 7: the separate wing of a biplane, and how many matches lie on its upper and on its lower wing (shorter, and of another chord).
// A flat box comes to lie on itself in eight ways, proper and mirrored ones.
struct OnWings {
  int upper = 0, lower = 0, elsewhere = 0;
  bool operator==(const OnWings&) const = default;
};

OnWings wings_found(const Move& move) {
  constexpr int fine = 96;  // a wing is 1.2 voxels thick on the plane
  Params params = coarse(fine);
  params.match.matches = 24;
  const Shape wing = described(moved(box({0, 0, 0}, {0.17, 1.1, 0.028}), move), fine), plane = described(biplane(), fine);
  OnWings found;
  for (const Match& match : match_shapes(wing, plane, params).matches) {
    Vec3 centre = Vec3::Zero();
    for (const Vec3& node : wing.body.nodes) centre += match.data_from_model(node) / static_cast<double>(wing.body.nodes.size());
    const bool upper = (centre - Vec3(0.3, 0, 0.32)).norm() < right * plane.diagonal;
    const bool lower = (centre - Vec3(0.2, 0, -0.14)).norm() < right * plane.diagonal;
    ++(upper ? found.upper : lower ? found.lower : found.elsewhere);
    if (found.upper + found.lower + found.elsewhere == 1) EXPECT_TRUE(upper) << "the wing's own place comes first";
  }
  return found;
}

const Move turned_and_large{random_rotation(5), 30, {5, 1, 2}};

TEST(WholeWay, AWingOfABiplaneIsFoundInItsOwnPlaceInEveryWayItFits) {
  EXPECT_EQ(wings_found({}).upper, 8);
  EXPECT_EQ(wings_found(turned_and_large).upper, 8);
}

// Wrong: a thin plate askew on the grid has dozens of points along its edges that the other wing has not: that one is found twice or never.
TEST(WholeWay, DISABLED_AWingOfABiplaneIsFoundAsOftenAsItOccurs) {
  EXPECT_EQ(wings_found({}), (OnWings{8, 8, 0}));
  EXPECT_EQ(wings_found(turned_and_large), (OnWings{8, 8, 0}));
}

TEST(WholeWay, ThePapersQuadruplesFindTheBiplaneInItself) {
  Params params = paper_preset();
  params.voxel.resolution = 64;
  params.salient.sigma0 = 0.8;
  const Shape shape = describe_shape(mesh_of(biplane(), 64), params);
  const Family family = match_shapes(shape, shape, params);
  ASSERT_FALSE(family.matches.empty());
  EXPECT_LT(error_of(family.matches[0], shape, shape, {}), right);
}

TEST(WholeWay, AHandFindsItselfAndCountsTellHowFarTheWayWent) {
  const Shape shape = described(hand());
  const Family family = match_shapes(shape, shape, coarse());
  ASSERT_FALSE(family.matches.empty());
  EXPECT_LT(error_of(family.matches[0], shape, shape, {}), right);
  ASSERT_EQ(family.counts.stages.front().first, "model points");
  EXPECT_EQ(family.counts.stages.front().second, static_cast<long>(shape.points.size()));
  EXPECT_EQ(family.counts.stages.back(), std::pair(std::string("matches"), static_cast<long>(family.matches.size())));
}

}  // namespace
}  // namespace homolog
