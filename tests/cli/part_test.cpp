// SPDX-License-Identifier: MIT
// What --part, --model-part and --data-part understand.
#include "part.h"

#include <gtest/gtest.h>

#include "exit_codes.h"

namespace homolog::cli {
namespace {

void expect_box(const char* text, const Vec3& min, const Vec3& max) {
  const Box box = parse_part(text);
  EXPECT_EQ(box.min, min) << text;
  EXPECT_EQ(box.max, max) << text;
}

TEST(Part, HalfSpacesAndBandsAreSharesOfTheBox) {
  expect_box("y>0.5", {0, 0.5, 0}, {1, 1, 1});
  expect_box("x<0.3", {0, 0, 0}, {0.3, 1, 1});
  expect_box("z=0.4..0.8", {0, 0, 0.4}, {1, 1, 0.8});
  expect_box("z=0..1", {0, 0, 0}, {1, 1, 1});
}

TEST(Part, ClausesAreCutOneAfterAnother) {
  expect_box("x<0.3,z>0.2", {0, 0, 0.2}, {0.3, 1, 1});
  expect_box("x>0.1,x>0.2,x<0.6,x=0.3..0.9", {0.3, 0, 0}, {0.6, 1, 1});
  expect_box("y>2.5e-1", {0, 0.25, 0}, {1, 1, 1});
}

TEST(Part, WhatIsNotUnderstoodIsRefusedWithTheTextAndAnExample) {
  for (const char* text : {"", "y", "y>", "w>0.5", "Y>0.5", "y>1.5", "y>-1", "y>0.5,", ",", "y=0.2", "y=0.2..", "y=..0.2", "y=1..2",
                           "y>0.5z<1", "y>nan", "y>inf", "y >0.5", "y>0,5", "y>=0.5"}) {
    try {
      parse_part(text);
      ADD_FAILURE() << text;
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("y>0.5 or"), std::string::npos);
    }
  }
}

TEST(Part, EmptyPartsAreRefused) {
  for (const char* text : {"y>0.6,y<0.5", "x=0.5..0.5", "z>1", "z<0", "x=0.8..0.2"}) EXPECT_THROW(parse_part(text), UsageError) << text;
}

}  // namespace
}  // namespace homolog::cli
