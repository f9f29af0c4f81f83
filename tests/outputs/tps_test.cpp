// SPDX-License-Identifier: MIT
#include "homolog/outputs/tps.h"

#include <gmock/gmock.h>

#include "outputs/message_of.h"

namespace homolog {
namespace {

using testing::HasSubstr;

std::string message(const std::string& text) {
  return message_of([&] { read_tps(text, "a.tps"); });
}

TEST(Tps, ReadsBackWhatItWritesMissingOnesUndefined) {
  const Specimen specimen{"bear 1", {{"nose", "", Vec3(0.1, -2, 3e-20)}, {"left ear = L", "", {}}, {"3", "", Vec3(4, 5, 6)}}};
  EXPECT_EQ(tps_text(specimen),
            "LM3=3\n0.1 -2 3e-20\nNA NA NA\n4 5 6\n"
            "COMMENT=landmark 1: nose\nCOMMENT=landmark 2: left ear = L\nID=bear 1\n");
  const auto specimens = read_tps(tps_text(specimen), "a.tps");
  ASSERT_EQ(specimens.size(), 1u);
  EXPECT_EQ(specimens[0].name, "bear 1");
  ASSERT_EQ(specimens[0].points.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(specimens[0].points[i].position, specimen.points[i].position);
    EXPECT_EQ(specimens[0].points[i].label, specimen.points[i].label);
  }
}

TEST(Tps, ReadsCollectionsWithCurvesScalesAndWhatElseThereIs) {
  const auto specimens = read_tps(
      "lm3=1\r\n1 2 3\r\nCURVES=2\r\nPOINTS=1\r\n4 5 6\r\nPOINTS=2\r\n7 8 9\r\n-1 -1 -1\r\nIMAGE=a.jpg\r\nID=a\r\nSCALE=0.5\r\n\r\n"
      "LM=1\r\n1 1 1\r\nOUTLINES=1\r\nPOINTS=2\r\n5 5\r\n6 6\r\nIMAGE=b.jpg\r\nCOMMENT=none\r\nVARIABLES=x\r\n",
      "a.tps");
  ASSERT_EQ(specimens.size(), 2u);
  const auto& points = specimens[0].points;
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[0].position, Vec3(0.5, 1, 1.5));
  EXPECT_EQ(points[1].label, "C1.1");
  EXPECT_EQ(points[3].label, "C2.2");
  EXPECT_EQ(points[3].position, Vec3(-0.5, -0.5, -0.5)) << "negative numbers are coordinates";
  EXPECT_EQ(specimens[1].name, "b.jpg");
  EXPECT_EQ(specimens[1].points.size(), 1u);
}

TEST(Tps, ReadsCurvesThatSayTheyAreOfThree) {
  const auto specimens = read_tps("LM3=1\n1 2 3\nCURVES3=1\nPOINTS3=1\n4 5 6\nID=a\n", "a.tps");
  ASSERT_EQ(specimens.size(), 1u);
  ASSERT_EQ(specimens[0].points.size(), 2u);
  EXPECT_EQ(specimens[0].points[1].label, "C1.1");
}

TEST(Tps, NamesTheLineOfAnError) {
  EXPECT_THAT(message("\n"), HasSubstr("a.tps, line 1: the file holds no LM3="));
  EXPECT_THAT(message("ID=a\nLM3=0\n"), HasSubstr("line 1: a specimen begins with LM3="));
  EXPECT_THAT(message("LM=1\n1 2\n"), HasSubstr("line 2: a landmark needs three coordinates"));
  EXPECT_THAT(message("LM3=1\n1 2 3 4\n"), HasSubstr("line 2: a landmark has three coordinates, but here are more"));
  EXPECT_THAT(message("LM3=2\n1 2 3\n"), HasSubstr("line 2: the file ends after 1 of 2 landmarks"));
  EXPECT_THAT(message("LM3=3\n1 2 3\nID=a\n"), HasSubstr("line 3: 3 landmarks are announced, but 1 are there"));
  EXPECT_THAT(message("LM3=1\n1 2 3\n4 5 6\n"), HasSubstr("line 3: here should be KEY=VALUE"));
  EXPECT_THAT(message("LM3=1\n1 NA 3\n"), HasSubstr("line 2: some coordinates are missing, but not all"));
  EXPECT_THAT(message("LM3=-1\n"), HasSubstr("line 1: the number of landmarks is negative"));
  EXPECT_THAT(message("LM3=1\n1e300 0 0\nSCALE=1e300\n"), HasSubstr("line 3: the scaled coordinates are not finite"));
}

}  // namespace
}  // namespace homolog
