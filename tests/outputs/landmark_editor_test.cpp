// SPDX-License-Identifier: MIT
#include "homolog/outputs/landmark_editor.h"

#include <gmock/gmock.h>

#include "outputs/message_of.h"

namespace homolog {
namespace {

using testing::HasSubstr;

std::string message(const std::string& text) {
  return message_of([&] { read_pts(text, "a.pts"); });
}

TEST(LandmarkEditor, ReadsBackWhatItWritesMissingOnesUndefined) {
  const std::vector<MarkupPoint> points{{"left 'eye' #1", "", Vec3(0.1, -2, 3e-20)}, {"ear", "", {}}};
  EXPECT_EQ(pts_text({points[0], points[1]}), "Version 1.0\n2\nleft__eye___1 0.1 -2 3e-20\near 9999 9999 9999\n");
  const auto again = read_pts(pts_text({points[0], points[1], {"", "", Vec3(7, 8, 9)}}), "a.pts");
  ASSERT_EQ(again.size(), 3u);
  EXPECT_EQ(again[0].position, points[0].position);
  EXPECT_EQ(again[1].label, "ear");
  EXPECT_FALSE(again[1].position);
  EXPECT_EQ(again[2].label, "S002");
}

TEST(LandmarkEditor, ReadsSinglePointsAndCurves) {
  const auto points = read_pts("Version 1.0\r\n2\r\nS000 1 2 3\r\n\r\nC000 4 5 6\r\n", "a.pts");
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[1].label, "C000");
  EXPECT_EQ(points[1].position, Vec3(4, 5, 6));
}

TEST(LandmarkEditor, NamesTheLineOfAnError) {
  EXPECT_THAT(message("S000 1 2 3\n"), HasSubstr("a.pts, line 1: the first line must be 'Version 1.0'"));
  EXPECT_THAT(message("Version 1.0\n"), HasSubstr("line 1: the number of points is missing"));
  EXPECT_THAT(message("Version 1.0\nmany\n"), HasSubstr("line 2: 'many' is not a whole number"));
  EXPECT_THAT(message("Version 1.0\n2\nS000 1 2 3\n"), HasSubstr("line 3: the file ends after 1 of 2 points"));
  EXPECT_THAT(message("Version 1.0\n1\nS000 1 2 3\nS001 1 2 3\n"), HasSubstr("line 4: more points follow than the 1 announced"));
  EXPECT_THAT(message("Version 1.0\n1\nS000 1 2\n"), HasSubstr("line 3: a landmark needs three coordinates"));
  EXPECT_THAT(message("Version 1.0\n1\nS000 9999 2 3\n"), HasSubstr("line 3: some coordinates are missing"));
}

}  // namespace
}  // namespace homolog
