// SPDX-License-Identifier: MIT
#include "homolog/outputs/doubt.h"

#include <gtest/gtest.h>

namespace homolog {
namespace {

Family family_of(const std::vector<double>& confidences) {
  Family family;
  for (const double confidence : confidences) family.matches.emplace_back().confidence = confidence;
  return family;
}

TEST(Doubt, IsSaidWhenEveryMatchIsMoreProbablyWrongThanRight) {
  EXPECT_EQ(doubt_sentence(family_of({0.03, 0.123, 0.01})), "No match here is likely to be right: the highest confidence is 0.12.");
  EXPECT_EQ(doubt_sentence(family_of({0.3, 0.5})), "");
  EXPECT_EQ(doubt_sentence(family_of({0.9, 0.1})), "");
}

TEST(Doubt, IsSaidOfOneMatchByItsConfidence) {
  EXPECT_EQ(doubt_of_match(0.123), "this match is more likely wrong than right: its confidence is 0.12");
  EXPECT_EQ(doubt_of_match(0.5), "");
}

TEST(Doubt, IsNotSaidWhereNothingWasFound) { EXPECT_EQ(doubt_sentence({}), ""); }

}  // namespace
}  // namespace homolog
