// SPDX-License-Identifier: MIT
// Sec. 6.2.1, eq. 7: candidates against brute force.
#include "homolog/match/candidates.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fixtures/shapes.h"
#include "match/synthetic_pairs.h"

namespace homolog {
namespace {

Shape shape_of(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<SalientPoint> points;
  std::vector<float> descriptors;
  for (int i = 0; i < count; ++i) {
    points.push_back(synthetic::salient_point(random));
    descriptors.push_back(static_cast<float>(synthetic::uniform(random, 0, 10)));
  }
  return fixtures::bare_shape(points, descriptors);
}

double distance(const Shape& a, int i, const Shape& b, int j) { return std::abs(double(a.descriptors[i][0]) - b.descriptors[j][0]); }

// How many points of b are nearer to point i of a than point j is.
int rank(const Shape& a, int i, const Shape& b, int j) {
  int nearer = 0;
  for (std::size_t k = 0; k < b.points.size(); ++k) nearer += distance(a, i, b, static_cast<int>(k)) < distance(a, i, b, j);
  return nearer;
}

TEST(Candidates, AreTheNearestPartnersBothWays) {
  const Shape model = shape_of(17, 1), data = shape_of(31, 2);
  for (const int partners : {1, 3, 10}) {
    Params params;
    params.match.partners = partners;
    const CorrespondenceSet candidates = find_candidates(model, data, params);
    std::size_t next = 0;
    for (int i = 0; i < 17; ++i) {
      for (int j = 0; j < 31; ++j) {
        if (rank(model, i, data, j) >= partners && rank(data, j, model, i) >= partners) continue;
        ASSERT_LT(next, candidates.size());
        const Correspondence& c = candidates[next++];  // ordered by (model, data)
        EXPECT_EQ(std::pair(c.model, c.data), std::pair(i, j));
        EXPECT_DOUBLE_EQ(c.descriptor_distance, distance(model, i, data, j));
        EXPECT_EQ(c.model_point.position, model.points[i].position);
        EXPECT_EQ(c.data_point.position, data.points[j].position);
      }
    }
    EXPECT_EQ(next, candidates.size());
  }
}

TEST(Candidates, WithMorePartnersThanPointsAllPairsStay) {
  Params params;
  params.match.partners = 100;
  EXPECT_EQ(find_candidates(shape_of(5, 1), shape_of(7, 2), params).size(), 35u);
}

TEST(Sec62, CorrespondencesBeyondTheThresholdArePruned) {
  const Shape model = shape_of(12, 3), data = shape_of(12, 4);
  Params params = paper_preset();
  params.match.partners = 100;
  const CorrespondenceSet candidates = find_candidates(model, data, params);
  std::size_t expected = 0;
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 12; ++j) expected += distance(model, i, data, j) < params.paper.descriptor_limit;
  }
  EXPECT_EQ(candidates.size(), expected);
  EXPECT_GT(expected, 0u);
}

// Plates have hundreds of faint points; the time that a search takes must not grow with them.
TEST(Candidates, AreAmongThePointsThatAnswerStrongest) {
  Shape model = shape_of(30, 5), data = shape_of(40, 6);
  for (int i = 0; i < 30; ++i) model.points[i].response = i % 3 == 0 ? 0.9 : 0.5;  // ten strong ones
  for (int j = 0; j < 40; ++j) data.points[j].response = 1 - 0.01 * j;
  Params params;
  params.match.searched_points = 10;
  params.match.partners = 100;
  const CorrespondenceSet candidates = find_candidates(model, data, params);
  EXPECT_EQ(candidates.size(), 100u);
  for (const Correspondence& c : candidates) EXPECT_TRUE(c.model % 3 == 0 && c.data < 10) << c.model << ' ' << c.data;
}

TEST(Candidates, NothingHasNoPartners) {
  EXPECT_TRUE(find_candidates(shape_of(0, 1), shape_of(7, 2), {}).empty());
  EXPECT_TRUE(find_candidates(shape_of(7, 1), shape_of(0, 2), {}).empty());
}

}  // namespace
}  // namespace homolog
