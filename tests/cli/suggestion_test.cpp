// SPDX-License-Identifier: MIT
#include "suggestion.h"

#include <gtest/gtest.h>

namespace homolog::cli {
namespace {

const std::vector<std::string> words{"match", "symmetry", "points", "params"};

TEST(Suggestion, IsTheNearestWordWithinAThirdOfItsLetters) {
  EXPECT_EQ(suggestion("mtch", words), "; did you mean 'match'?");
  EXPECT_EQ(suggestion("simetry", words), "; did you mean 'symmetry'?");
  EXPECT_EQ(suggestion("point", words), "; did you mean 'points'?");
}

TEST(Suggestion, IsAnOptionOfWhichThisIsTheEnd) {
  EXPECT_EQ(suggestion("--label", {"--model-label", "--data-label"}), "; did you mean '--model-label'?");
  EXPECT_EQ(suggestion("--abel", {"--unlabelled"}), "");
}

TEST(Suggestion, StrangersGetNone) {
  EXPECT_EQ(suggestion("frobnicate", words), "");
  EXPECT_EQ(suggestion("", words), "");
  EXPECT_EQ(suggestion("match", {}), "");
}

}  // namespace
}  // namespace homolog::cli
