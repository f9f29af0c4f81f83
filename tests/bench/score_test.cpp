// SPDX-License-Identifier: MIT
// The bench must be able to fail: perfect, noisy, swapped, half-wrong, doubled and empty results on truth made here.
#include "score.h"

#include <gtest/gtest.h>

#include <random>

#include "summary.h"

namespace homolog::bench {
namespace {

constexpr double diagonal = 2;

// A cloud without symmetry of its own, carried by a known similarity; the swapped answer is its image at x -> -x.
struct Case {
  Similarity map = random_similarity(7, "case", 1);
  TruePoints points;
  std::vector<SalientPoint> model, data;
  double data_diagonal = diagonal * map.scale;

  Case() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-0.57, 0.57);
    for (int i = 0; i < 300; ++i) {
      const Vec3 x(unit(random), unit(random), unit(random));
      points.model.push_back(x);
      points.data.push_back(map(x));
      points.swapped_data.push_back(map({-x.x(), x.y(), x.z()}));
    }
    for (int i = 0; i < 10; ++i) {
      SalientPoint m{.position = points.model[static_cast<std::size_t>(i)] * 0.8, .radius = 0.1};
      model.push_back(m);
      data.push_back({.position = map(m.position), .radius = m.radius * map.scale});
    }
  }

  Match match(int count = 10) const {
    Match match;
    for (int i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      match.pairs.push_back({.model = i, .data = i, .model_point = model[k], .data_point = data[k]});
    }
    lay_warp(match);
    return match;
  }

  // Moves the data point of every pair from the first on by so many data diagonals.
  Match moved(int count, double by) const {
    Match match = this->match();
    for (int i = 0; i < count; ++i) match.pairs[static_cast<std::size_t>(i)].data_point.position += by * data_diagonal * Vec3::UnitX();
    lay_warp(match);
    return match;
  }

  static void lay_warp(Match& match) {
    std::vector<Vec3> from, to;
    for (const auto& c : match.pairs) from.push_back(c.model_point.position), to.push_back(c.data_point.position);
    const SourceSystem system(from, std::vector<double>(from.size()));
    match.data_from_model =
        ThinPlateSpline::similarity_free(system, to, match.handedness == Handedness::mirrored ? Chirality::mirrored : Chirality::proper);
  }

  PairScore score(std::vector<Match> matches) const {
    return score_family({std::move(matches), {}}, model, data, make_truth(points), data_diagonal);
  }
};

TEST(Score, PerfectResultIsRight) {
  const Case c;
  const PairScore s = c.score({c.match()});
  EXPECT_TRUE(s.success && s.success_direct && s.success_in_six);
  EXPECT_EQ(s.first.right, 10);
  EXPECT_EQ(s.findable, 10);
  EXPECT_EQ(s.findable_found, 10);
  EXPECT_LT(s.transfer.mean, 1e-6);
  EXPECT_EQ(s.transfer.within_05, 1);
  EXPECT_EQ(s.lost, Stage::ok);
  EXPECT_TRUE(s.handedness_right);
}

TEST(Score, SmallNoiseIsForgivenLargeIsNot) {
  const Case c;
  EXPECT_EQ(c.score({c.moved(10, 0.045)}).first.right, 10);
  const PairScore far = c.score({c.moved(10, 0.06)});
  EXPECT_EQ(far.first.right, 0);
  EXPECT_FALSE(far.success);
  EXPECT_NEAR(far.transfer.median, 0.06, 1e-6);
  EXPECT_EQ(far.transfer.within_05, 0);
  EXPECT_EQ(far.transfer.within_10, 1);
}

TEST(Score, FortyPerCentWrongFails) {
  const Case c;
  EXPECT_TRUE(c.score({c.moved(3, 0.5)}).success);
  const PairScore s = c.score({c.moved(4, 0.5)});
  EXPECT_FALSE(s.success);
  EXPECT_EQ(s.first.right, 6);
  EXPECT_EQ(s.lost, Stage::family);
}

TEST(Score, SwappedIsRightButNotDirect) {
  const Case c;
  Match match = c.match();
  for (auto& pair : match.pairs) {
    const Vec3 x = pair.model_point.position;
    pair.data_point.position = c.map({-x.x(), x.y(), x.z()});
  }
  match.handedness = Handedness::mirrored;
  Case::lay_warp(match);
  const PairScore s = c.score({match});
  EXPECT_TRUE(s.success && s.first.swapped && s.handedness_right);
  EXPECT_FALSE(s.success_direct);
  EXPECT_LT(s.transfer.mean, 1e-6);
  Case unsymmetric;
  unsymmetric.points.swapped_data.clear();
  EXPECT_FALSE(unsymmetric.score({match}).success);
}

TEST(Score, DoubledPointsAreWrong) {
  const Case c;
  Match match = c.match(6);
  match.pairs.push_back(match.pairs[0]);
  match.pairs.push_back({.model = 7, .data = 1, .model_point = c.model[7], .data_point = c.data[1]});
  const PairScore s = c.score({match});
  EXPECT_EQ(s.first.right, 4);
  EXPECT_FALSE(s.success);
}

TEST(Score, EmptyAndShortResultsFail) {
  const Case c;
  const PairScore empty = c.score({});
  EXPECT_FALSE(empty.found || empty.success || empty.success_in_six);
  EXPECT_EQ(empty.findable, 10);
  EXPECT_EQ(empty.lost, Stage::family);
  EXPECT_EQ(empty.transfer.within_10, 0);
  EXPECT_FALSE(c.score({c.match(3)}).success);
  EXPECT_TRUE(c.score({c.match(4)}).success);
}

TEST(Score, RanksTheFirstRightMatch) {
  const Case c;
  const PairScore third = c.score({c.moved(10, 0.5), c.moved(6, 0.5), c.match()});
  EXPECT_EQ(third.first_right, 3);
  EXPECT_TRUE(third.success_in_six);
  EXPECT_EQ(third.lost, Stage::ranking);
  std::vector<Match> seven(6, c.moved(10, 0.5));
  seven.push_back(c.match());
  EXPECT_FALSE(c.score(seven).success_in_six);
  EXPECT_EQ(c.score(seven).first_right, 7);
}

TEST(Score, PointsThatWereNotDetectedAreTold) {
  Case c;
  for (SalientPoint& point : c.data) point.radius *= 2;
  EXPECT_EQ(c.score({}).findable, 0);
  EXPECT_EQ(c.score({}).lost, Stage::points);
}

TEST(Score, CalibrationErrorIsTheGapBetweenConfidenceAndSuccess) {
  std::vector<Result> results(4);
  for (std::size_t i = 0; i < 4; ++i) {
    results[i].score.found = true;
    results[i].score.confidence = 0.9;
    results[i].score.first.success = i > 0;
  }
  std::vector<const Result*> group;
  for (const Result& r : results) group.push_back(&r);
  EXPECT_NEAR(calibration_error(group), 0.15, 1e-12);
  results[0].score.confidence = 0.1;
  EXPECT_NEAR(calibration_error(group), 0.25 * 0.1 + 0.75 * 0.1, 1e-12);
}

TEST(Summary, NothingFoundCountsZeroAndErrorsAreFailures) {
  const Case c;
  std::vector<Result> results(2);
  results[0].score = c.score({c.match()});
  results[1].score.error = "thrown";
  for (Result& r : results) r.pair = {"whole", "set/a", "set/b", ""};
  EXPECT_NE(summary(results).find("errors 1"), std::string::npos);
  EXPECT_NE(summary(results).find("0.500"), std::string::npos);
  EXPECT_NE(readable_row(results[1]).find("error: thrown"), std::string::npos);
}

TEST(Summary, ARunWithoutPairsOrWithErrorsIsComplainedOf) {
  std::vector<Result> results(2);
  EXPECT_EQ(complaint(results), "");
  results[1].score.error = "thrown";
  EXPECT_EQ(complaint(results), "1 of 2 pairs ended in an error");
  EXPECT_NE(complaint({}).find("no pairs"), std::string::npos);
}

TEST(Summary, UnrelatedPairsThatThrowAreErrorsAndNotUnclaimed) {
  std::vector<Result> results(3);
  for (Result& r : results) r.pair = {unrelated, "set/a", "set/b", ""};
  results[0].score.instances_claimed = 1;
  results[2].score.error = "thrown";
  const std::string text = summary(results);
  EXPECT_NE(text.find("errors 1\n"), std::string::npos);
  EXPECT_NE(text.find("pairs that share nothing: 2; claimed with confidence of .5 or more: 1; errors besides: 1"), std::string::npos);
}

TEST(Summary, TellsHandednessWithAndWithoutASwappedTruth) {
  const Case symmetric;
  Case other;
  other.points.swapped_data.clear();
  Match unsure = symmetric.match();
  unsure.handedness = Handedness::ambiguous;
  std::vector<Result> results(4);
  results[0].score = symmetric.score({unsure});
  results[1].score = symmetric.score({symmetric.match()});
  results[2].score = other.score({other.match()});
  results[3].score = other.score({unsure});
  const std::string text = summary(results);
  EXPECT_NE(text.find("2 right, 0 wrong, 2 ambiguous; 0 told mirrored"), std::string::npos);
  EXPECT_NE(text.find("with a swapped truth: 1 of 2 ambiguous; without: 1 right, 0 wrong, 1 ambiguous"), std::string::npos);
}

}  // namespace
}  // namespace homolog::bench
