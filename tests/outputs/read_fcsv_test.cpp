// SPDX-License-Identifier: MIT
#include "homolog/outputs/read_fcsv.h"

#include <gmock/gmock.h>

#include "outputs/message_of.h"

namespace homolog {
namespace {

using testing::HasSubstr;

const std::string columns = "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n";

std::string fcsv(const std::string& system, const std::string& rows) {
  return "# Markups fiducial file version = 4.13\n# CoordinateSystem = " + system + "\n" + columns + rows;
}

std::string message(const std::string& text) {
  return message_of([&] { read_fcsv(text, "a.fcsv"); });
}

TEST(ReadFcsv, GoesByTheFilesOwnCoordinateSystemInNumbersAndNames) {
  const auto position = [](const std::string& system) { return read_fcsv(fcsv(system, "1,1,2,3,0,0,0,1,1,1,0,a,,\n"), "a")[0].position; };
  EXPECT_EQ(position("LPS"), Vec3(1, 2, 3));
  EXPECT_EQ(position("1"), Vec3(1, 2, 3));
  EXPECT_EQ(position("RAS"), Vec3(-1, -2, 3));
  EXPECT_EQ(position("0"), Vec3(-1, -2, 3));
}

TEST(ReadFcsv, TakesLabelsAndDescriptionsByTheNamedColumns) {
  const auto points =
      read_fcsv("# CoordinateSystem = LPS\r\n# columns = label,z,y,x,desc\r\n\"a, \"\"b\"\"\",3,2,1,big\r\n\r\nc,6,5,4,\r\n", "a");
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].label, "a, \"b\"");
  EXPECT_EQ(points[0].description, "big");
  EXPECT_EQ(points[0].position, Vec3(1, 2, 3));
  EXPECT_EQ(points[1].position, Vec3(4, 5, 6));
}

TEST(ReadFcsv, PointsThatAreNotDefinedAreMissingHiddenOnesAreNot) {
  const auto points = read_fcsv(fcsv("LPS",
                                     "1,1,2,3,0,0,0,1,0,0,1,hidden,,,2,0\n2,0,0,0,0,0,0,1,1,1,0,undefined,,,0,0\n"
                                     "3,0,0,0,0,0,0,1,1,1,0,absent,,,3,0\n4,,,,0,0,0,1,1,1,0,empty,,\n"),
                                "a");
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[0].position, Vec3(1, 2, 3));
  for (int i : {1, 2, 3}) EXPECT_FALSE(points[i].position) << points[i].label;
  EXPECT_FALSE(points[0].display.selected);
  EXPECT_TRUE(points[0].display.locked);
  EXPECT_FALSE(points[0].display.visible);
  EXPECT_TRUE(points[1].display.selected && !points[1].display.locked && points[1].display.visible);
}

TEST(ReadFcsv, NamesTheLineOfAnError) {
  EXPECT_THAT(message(columns + "1,1,2,3\n"), HasSubstr("a.fcsv, line 2: no line '# CoordinateSystem = LPS' or RAS"));
  EXPECT_THAT(message(fcsv("IJK", "")), HasSubstr("a.fcsv, line 2: the coordinate system 'IJK' is not known"));
  EXPECT_THAT(message(fcsv("2", "")), HasSubstr("line 2: the coordinate system '2' is not known"));
  EXPECT_THAT(message(fcsv("LPS", "1,2\n")), HasSubstr("line 4: 2 cells, but a point needs"));
  EXPECT_THAT(message(fcsv("LPS", "1,1,two,3\n")), HasSubstr("line 4: 'two' is not a finite number"));
  EXPECT_THAT(message(fcsv("LPS", "1,1,,3\n")), HasSubstr("line 4: some coordinates are missing, but not all"));
}

}  // namespace
}  // namespace homolog
