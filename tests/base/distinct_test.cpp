// SPDX-License-Identifier: MIT
#include "homolog/base/distinct.h"

#include <gmock/gmock.h>

#include <cstdlib>

namespace homolog {
namespace {

bool close(int a, int b) { return std::abs(a - b) <= 1; }

TEST(Distinct, KeepsTheFirstOfThoseThatAreTheSame) {
  // 2 falls to 1; 3 differs from 1, for 2 is not there to ask.
  EXPECT_THAT(distinct(std::vector<int>{1, 2, 3, 9, 8}, 10, close), testing::ElementsAre(1, 3, 9));
}

TEST(Distinct, StopsAtTheMost) {
  EXPECT_THAT(distinct(std::vector<int>{5, 1, 9}, 2, close), testing::ElementsAre(5, 1));
  EXPECT_TRUE(distinct(std::vector<int>{5}, 0, close).empty());
}

}  // namespace
}  // namespace homolog
