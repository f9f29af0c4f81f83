// SPDX-License-Identifier: MIT
#include "homolog/match/repeated_pieces.h"

#include <gmock/gmock.h>

#include "fixtures/shapes.h"

namespace homolog {
namespace {

using namespace fixtures;
using Move = homolog::Similarity;

const Mat3 turn = random_rotation(3);
const Vec3 beside(3, 1, 0.5);

/// An L with arms of different length, and the same half as large and turned beside it.
Solid corner() { return join({capsule({0, 0, 0}, {0, 0, 2}, 0.25), capsule({0, 0, 0}, {0.8, 0, 0}, 0.25)}); }
const Shape& corners() {
  static const Shape shape = described(join({corner(), moved(corner(), {turn, 0.5, beside})}), 128);
  return shape;
}

std::vector<std::vector<int>> surfaces() { return separate_surfaces(corners().surface, corners().body, 12); }
const Shape& large() {
  static const Shape shape = piece_of(corners(), surfaces()[0]).shape;
  return shape;
}

double error_of(const Move& movement) { return repetition_error(movement, large().surface, large().diagonal, corners()); }

Match match_by(const Move& movement, double confidence) {
  Match match;
  match.similarity = movement;
  match.confidence = confidence;
  return match;
}

const Move onto_half{0.5, turn, beside};
/// As large as it lies in the bent map of a match that is right.
const Move rough{0.52, Eigen::AngleAxisd(0.05, Vec3::UnitX()).toRotationMatrix() * turn, beside + Vec3(0.02, 0, 0.01)};
const Move too_large{0.62, turn, beside};
const Move other_way{0.5, turn* Eigen::AngleAxisd(M_PI / 2, Vec3::UnitY()).toRotationMatrix(), beside};
const Move in_place{1, Vec3(1, -1, 1).asDiagonal().toDenseMatrix(), Vec3::Zero()};

TEST(RepetitionError, IsSmallForWhatLiesNearAnExactCopyAndLargeElsewhere) {
  EXPECT_LT(error_of(onto_half), 0.01);
  EXPECT_NEAR(error_of(rough), error_of(onto_half), 0.002);
  EXPECT_GT(error_of(other_way), 0.03);
  EXPECT_GT(error_of({1, Mat3::Identity(), {9, 9, 9}}), 0.09) << "nothing is there";
}

TEST(RepetitionError, AsksBothSurfaces) {
  const Shape arm = described(capsule({0, 0, 0}, {0, 0, 2}, 0.25));
  const double arm_alone = repetition_error({}, arm.surface, arm.diagonal, corners());
  EXPECT_GT(arm_alone, 2 * error_of(onto_half)) << "the other arm begins where it lies";
}

TEST(BelieveExact, AnExactCopyComesBeforeOneThatLiesBeside) {
  std::vector<Match> matches{match_by(other_way, 0.98), match_by(onto_half, 0.95)};
  believe_exact(matches, large(), corners());
  EXPECT_LT(matches[0].confidence, matches[1].confidence);
  EXPECT_NEAR(matches[1].confidence, 0.95, 0.01);
}

TEST(MovesAll, NotWhatMirrorsTheLargestPieceOnly) {
  EXPECT_FALSE(moves_all(match_by(in_place, 1), surfaces(), corners()));
  const Shape pair = described(join({moved(corner(), {Mat3::Identity(), 1, {0.7, 0, 0}}), moved(corner(), {mirror_x(), 1, {-0.7, 0, 0}})}));
  const auto both = separate_surfaces(pair.surface, pair.body, 12);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_TRUE(moves_all(match_by({1, mirror_x(), Vec3::Zero()}, 1), both, pair));
}

TEST(IsKnown, TheSameMovementOfThePieceIs) {
  EXPECT_TRUE(is_known(match_by(rough, 1), large(), {match_by(in_place, 1), match_by(onto_half, 1)}));
  EXPECT_FALSE(is_known(match_by(too_large, 1), large(), {match_by(onto_half, 1)}));
  EXPECT_FALSE(is_known(match_by(in_place, 1), large(), {match_by({}, 1)})) << "mirrored or not";
}

}  // namespace
}  // namespace homolog
