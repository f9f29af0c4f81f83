// SPDX-License-Identifier: MIT
#include "homolog/outputs/read_points.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "homolog/outputs/landmarks.h"
#include "outputs/match_fixture.h"
#include "outputs/message_of.h"

namespace homolog {
namespace {

using testing::HasSubstr;

std::string csv_message(const std::string& text) {
  return message_of([&] { read_points_csv(text, "a.csv"); });
}

TEST(Markups, KeepListsTypesAndUnits) {
  const std::vector<MarkupPoint> points{{"a", "", Vec3(1, 2, 3)}, {"b", "", {}}, {"c", "", Vec3(4, 5, 6)}};
  const std::string text = markups_text(points, false, {{2, "Curve", "edge", "um"}, {1, "Fiducial", "", "mm"}, {}});
  const std::vector<MarkupList> lists = read_markup_lists(text, "a");
  ASSERT_EQ(lists.size(), 3u);
  EXPECT_EQ(lists[0].points, 2u);
  EXPECT_EQ(lists[0].type, "Curve");
  EXPECT_EQ(lists[0].name, "edge");
  EXPECT_EQ(lists[0].units, "um");
  EXPECT_EQ(lists[1].units, "mm");
  EXPECT_EQ(lists[2].points, 0u);
  EXPECT_EQ(read_markups(text, "a")[2].position, Vec3(4, 5, 6));
  const auto plane = read_markup_lists(R"({"markups": [{"type": "Plane", "controlPoints": [{"position": [1, 2, 3]}]}]})", "a");
  EXPECT_EQ(plane[0].type, "Fiducial");
  EXPECT_EQ(plane[0].dropped, "Plane");
  EXPECT_EQ(message_of([&] { read_markup_lists(R"({"markups": [{"type": 1, "controlPoints": []}]})", "a"); }).substr(0, 3), "a: ");
}

std::string markups_message(const std::string& text) {
  return message_of([&] { read_markups(text, "a.mrk.json"); });
}

TEST(ReadPointsCsv, ReadsBackWhatLandmarksWrite) {
  const auto landmarks = point_landmarks(fixtures::shape("model.off", 1));
  const auto points = read_points_csv(landmarks_csv(landmarks), "a.csv");
  ASSERT_EQ(points.size(), landmarks.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].label, landmarks[i].label);
    EXPECT_EQ(points[i].position, landmarks[i].point.position);
  }
}

TEST(ReadPointsCsv, TakesCapitalsAndSemicolons) {
  const auto points = read_points_csv("Label;X;Y;Z\r\n\"a; b\";1;2;3\r\n", "a.csv");
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].label, "a; b");
  EXPECT_EQ(points[0].position, Vec3(1, 2, 3));
  EXPECT_THAT(csv_message("x;y;z\n1,5;2;3\n"),
              HasSubstr("line 2: '1,5' is not a number; save it with a decimal point instead of the comma"));
}

TEST(ReadPointsCsv, TakesTabsAndTheSeparatorThatTheFirstLineNames) {
  EXPECT_EQ(read_points_csv("label\tx\ty\tz\na, b\t1\t2\t3\n", "a.csv").at(0).label, "a, b");
  EXPECT_EQ(read_points_csv("sep=;\r\nx;y;z;label\r\n1;2;3;a, b\r\n", "a.csv").at(0).label, "a, b");
  EXPECT_EQ(read_points_csv("SEP=,\nx,y,z\n1,2,3\n", "a.csv").at(0).position, Vec3(1, 2, 3));
  EXPECT_THAT(csv_message("sep=,"), HasSubstr("the file ends before its header"));
}

TEST(ReadPointsCsv, TakesNamesForLabelsWhereThereAreNone) {
  EXPECT_EQ(read_points_csv("name,x,y,z\nnose,1,2,3\n", "a.csv")[0].label, "nose");
  EXPECT_EQ(read_points_csv("name,x,y,z,label\nnose,1,2,3,N\n", "a.csv")[0].label, "N");
}

TEST(ReadPointsCsv, TakesColumnsInAnyOrderQuotesAndMissingPoints) {
  const auto points = read_points_csv("z,label,extra,y,x\r\n3,\"a, \"\"b\"\"\",?,2,1\r\n\r\n,nose,,,\nNA,ear,,NA,NA\n", "a.csv");
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0].label, "a, \"b\"");
  EXPECT_EQ(points[0].position, Vec3(1, 2, 3));
  EXPECT_EQ(points[1].label, "nose");
  EXPECT_FALSE(points[1].position);
  EXPECT_FALSE(points[2].position);
}

TEST(ReadPointsCsv, NamesTheLineOfAnError) {
  EXPECT_THAT(csv_message("1,2,3\n"), HasSubstr("a.csv, line 1: the header must name the columns x, y and z"));
  EXPECT_THAT(csv_message("x,y,z\n1,2\n"), HasSubstr("a.csv, line 2: 2 cells, but the header has 3"));
  EXPECT_THAT(csv_message("x,y,z\n1,2,3\n1,two,3\n"), HasSubstr("a.csv, line 3: 'two' is not a finite number"));
  EXPECT_THAT(csv_message("x,y,z\n1,2 3,4\n"), HasSubstr("line 2: '2 3' is not a number"));
  EXPECT_THAT(csv_message("x,y,z\n1,,3\n"), HasSubstr("line 2: some coordinates are missing, but not all"));
  EXPECT_THAT(csv_message("x,y,z\n1,inf,3\n"), HasSubstr("line 2: 'inf' is not a finite number"));
  EXPECT_THAT(csv_message("x,y,z,label\n1,2,3,\"a\n"), HasSubstr("line 2: a quotation mark is not closed"));
  EXPECT_THAT(csv_message("x,y,z,label\n1,2,3,\"a\n1,2,3,b\n\n"), HasSubstr("line 2: a quotation mark is not closed"));
  EXPECT_THAT(csv_message("x,y,z,label\n1,2,3,\"a\nb\"\n1,two,3,c\n"), HasSubstr("line 4: 'two' is not a finite number"));
}

TEST(ReadPointsCsv, TakesLabelsOfSeveralLines) {
  const auto points = read_points_csv("x,y,z,label\r\n1,2,3,\"a, \"\"b\"\"\r\n\r\nc\"\r\n4,5,6,d\r\n", "a.csv");
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].label, "a, \"b\"\n\nc");
  EXPECT_EQ(points[1].label, "d");
}

// Notepad puts the mark of UTF-8 before everything; Excel calls UTF-16 Unicode text.
TEST(ReadPoints, TakesTheMarkOfUtf8InEveryFormatAndNamesUtf16) {
  const std::pair<std::string, std::string> files[] = {
      {"a.csv", "x,y,z\n1,2,3\n"},
      {"a.tps", "LM3=1\n1 2 3\nID=a\n"},
      {"a.pts", "Version 1.0\n1\np0 1 2 3\n"},
      {"a.txt", "[individuals]\n1\n[landmarks]\n1\n[dimensions]\n3\n[names]\na\n[rawpoints]\n'#1\n1 2 3\n"},
      {"a.fcsv", "# CoordinateSystem = LPS\n# columns = id,x,y,z\n1,1,2,3\n"}};
  for (const auto& [name, content] : files) {
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / ("read_points_test_" + name);
    std::ofstream(path, std::ios::binary) << "\xef\xbb\xbf" << content;
    const auto points = read_points(path);
    ASSERT_EQ(points.size(), 1u) << name;
    EXPECT_EQ(points[0].position, Vec3(1, 2, 3)) << name;
    std::ofstream(path, std::ios::binary) << "\xff\xfex";
    EXPECT_THAT(message_of([&] { read_points(path); }), HasSubstr("this is text in UTF-16; save it as UTF-8")) << name;
    std::filesystem::remove(path);
  }
}

TEST(ReadPointsCsv, AsksWhereAColumnComesTwice) {
  EXPECT_THAT(csv_message("label,x,y,z,X\na,1,2,3,4\n"), HasSubstr("the header names the column x twice; leave one"));
}

TEST(ReadMarkups, ReadsBackWhatMarkupsWrite) {
  const auto points = read_markups(markups_text({{"nose", "big", Vec3(0.1, -2, 3), {false, true, false}}, {"ear", "", {}}}), "a.mrk.json");
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].label, "nose");
  EXPECT_EQ(points[0].description, "big");
  EXPECT_EQ(points[0].position, Vec3(0.1, -2, 3));
  EXPECT_EQ(points[1].label, "ear");
  EXPECT_FALSE(points[1].position);
  EXPECT_FALSE(points[0].display.selected);
  EXPECT_TRUE(points[0].display.locked);
  EXPECT_FALSE(points[0].display.visible);
}

TEST(ReadMarkups, WhatSaysNothingOfItsDisplayIsShownAndSelected) {
  const auto points = read_markups(R"({"markups": [{"controlPoints": [{"position": [1, 2, 3], "locked": 0}]}]})", "a");
  EXPECT_TRUE(points[0].display.selected && !points[0].display.locked && points[0].display.visible);
}

TEST(ReadMarkups, GoesByTheFilesOwnCoordinateSystem) {
  const std::string points = R"("controlPoints": [{"label": "a", "position": [1, 2, 3]}])";
  const auto position = [&](const std::string& system) {
    return read_markups("{\"markups\": [{" + system + points + "}]}", "a")[0].position;
  };
  EXPECT_EQ(position(R"("coordinateSystem": "LPS",)"), Vec3(1, 2, 3));
  EXPECT_EQ(position(R"("coordinateSystem": "RAS",)"), Vec3(-1, -2, 3));
  EXPECT_EQ(position(""), Vec3(1, 2, 3)) << "Slicer's schema: LPS unless it is stated";
}

TEST(ReadMarkups, StatesTheSystemOfTheMesh) {
  const std::string text = markups_text({{"a", "", Vec3(1, 2, 3)}}, true);
  EXPECT_THAT(text, testing::HasSubstr("\"coordinateSystem\": \"RAS\""));
  EXPECT_EQ(read_markups(text, "a")[0].position, Vec3(-1, -2, 3));
}

TEST(ReadMarkups, TakesUndefinedPointsForMissingWhateverTheirPosition) {
  // Slicer itself writes an empty string where a position would stand.
  const auto points = read_markups(R"({"markups": [{"coordinateSystem": "LPS", "controlPoints": [
    {"label": "a", "position": "", "positionStatus": "undefined"},
    {"label": "b", "position": [0, 0, 0], "positionStatus": "missing"},
    {"label": "c", "positionStatus": "defined"}]}]})",
                                   "a");
  ASSERT_EQ(points.size(), 3u);
  for (const MarkupPoint& point : points) EXPECT_FALSE(point.position) << point.label;
}

TEST(ReadMarkups, SaysWhatIsWrong) {
  EXPECT_THAT(markups_message("{"), HasSubstr("a.mrk.json: this is not a file of markups of 3D Slicer"));
  EXPECT_THAT(markups_message("[1, 2]"), HasSubstr("a.mrk.json: this is not a file of markups"));
  EXPECT_THAT(markups_message(R"({"markups": [{"coordinateSystem": "XYZ", "controlPoints": []}]})"), HasSubstr("'XYZ' is not known"));
  EXPECT_THAT(markups_message(R"({"markups": [{"controlPoints": [{"label": "n", "position": [1, 2]}]}]})"),
              HasSubstr("point 'n': a position has three coordinates, not 2"));
}

}  // namespace
}  // namespace homolog
