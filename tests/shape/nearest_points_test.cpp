// SPDX-License-Identifier: MIT
#include "homolog/shape/nearest_points.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "shape/clouds.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

TEST(NearestPoints, AreThoseThatLookingAtAllOfThemFinds) {
  std::vector<Vec3> points = clouds::sampled(meshes::torus(1, 0.3, 20, 10), 300).points;
  points.insert(points.end(), points.begin(), points.begin() + 50);  // equal ones come by number
  const NearestPoints tree(points);
  for (const std::size_t count : {1u, 7u, 400u}) {
    for (std::size_t at = 0; at < points.size(); at += 10) {
      const Vec3 x = points[at] + Vec3(0.01, 0.2, -0.1);
      std::vector<NearestPoints::Neighbour> all;
      for (std::uint32_t i = 0; i < points.size(); ++i) all.push_back({(points[i] - x).squaredNorm(), i});
      std::sort(all.begin(), all.end());
      all.resize(std::min(count, all.size()));
      EXPECT_EQ(tree.nearest(x, count), all);
    }
  }
}

TEST(NearestPoints, OfNoneThereIsNone) { EXPECT_TRUE(NearestPoints({}).nearest(Vec3::Zero(), 3).empty()); }

}  // namespace
}  // namespace homolog
