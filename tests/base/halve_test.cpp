// SPDX-License-Identifier: MIT
#include "homolog/base/halve.h"

#include <gmock/gmock.h>

#include "homolog/base/vec.h"

namespace homolog {
namespace {

TEST(Halve, CutsAcrossTheLongestSideWhateverTheOrderBefore) {
  const std::vector<Vec3> places{{0, 0, 3}, {1, 0, 1}, {0, 1, 0}, {1, 1, 2}, {0, 0, 2}};
  for (std::vector<int> order : {std::vector<int>{0, 1, 2, 3, 4}, std::vector<int>{4, 3, 2, 1, 0}}) {
    halve(order.begin(), order.begin() + 3, order.end(), places);
    EXPECT_THAT(std::vector<int>(order.begin(), order.begin() + 3), testing::UnorderedElementsAre(2, 1, 3));  // of 3 and 4, the first
    EXPECT_EQ(order[3], 4);
  }
}

}  // namespace
}  // namespace homolog
