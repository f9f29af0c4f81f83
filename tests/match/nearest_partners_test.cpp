// SPDX-License-Identifier: MIT
// Against all pairs compared one by one.
#include "homolog/match/nearest_partners.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace homolog {
namespace {

constexpr double turned_away = 0.7;

Facets facets(int count, unsigned seed) {
  std::srand(seed);  // Eigen's
  Facets made{Eigen::ArrayX3f::Random(count, 3), Eigen::ArrayX3f::Random(count, 3)};
  for (int i = 0; i < count; ++i) made.normals.row(i) /= made.normals.row(i).matrix().norm();
  return made;
}

double cost(const Facets& a, int i, const Facets& b, int j) {
  const double agreement = (a.normals.row(i) * b.normals.row(j)).sum();
  return (a.places.row(i) - b.places.row(j)).square().sum() + turned_away * turned_away * (1 - agreement);
}

int nearest(const Facets& from, int i, const Facets& to) {
  int best = 0;
  for (int j = 1; j < to.places.rows(); ++j) {
    if (cost(from, i, to, j) < cost(from, i, to, best)) best = j;
  }
  return best;
}

TEST(NearestPartners, AreThoseOfAllPairsBothWays) {
  for (const auto& [m, n] : {std::pair(1, 1), std::pair(1, 9), std::pair(7, 8), std::pair(150, 61)}) {
    const Facets model = facets(m, 1), data = facets(n, 2);
    const Partners partners = nearest_partners(model, data, turned_away);
    ASSERT_EQ(partners.of_model.size(), static_cast<std::size_t>(m));
    ASSERT_EQ(partners.of_data.size(), static_cast<std::size_t>(n));
    double forth = 0, back = 0;
    for (int i = 0; i < m; ++i) {
      EXPECT_EQ(partners.of_model[i], nearest(model, i, data));
      forth += std::sqrt(cost(model, i, data, partners.of_model[i])) / m;
    }
    for (int j = 0; j < n; ++j) {
      EXPECT_EQ(partners.of_data[j], nearest(data, j, model));
      back += std::sqrt(cost(data, j, model, partners.of_data[j])) / n;
    }
    EXPECT_NEAR(partners.model_distance, forth, 1e-5);
    EXPECT_NEAR(partners.data_distance, back, 1e-5);
  }
}

TEST(NearestPartners, OfEquallyNearOnesTheFirstIsTaken) {
  const Facets one = facets(1, 1), many{one.places.replicate(20, 1), one.normals.replicate(20, 1)};
  EXPECT_EQ(nearest_partners(one, many, turned_away).of_model[0], 0);
  EXPECT_EQ(nearest_partners(many, one, turned_away).of_data[0], 0);
}

}  // namespace
}  // namespace homolog
