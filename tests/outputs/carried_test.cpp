// SPDX-License-Identifier: MIT
#include "homolog/outputs/carried.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "homolog/outputs/read_points.h"
#include "homolog/shape/read_ply.h"

namespace homolog {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::vector<CarriedLandmark> landmarks{{"nose", CarriedPoint{{1, 2, 0.5}, true, 0.25, 0.75}},
                                             {"a, \"b\"", CarriedPoint{{4, 5, 6}, true, 0.5, 0.125}},
                                             {"ear", CarriedPoint{{7, 8, 9}, false, 0.5, 1}},
                                             {"tail", {}},
                                             {"foot", CarriedPoint{{1, 1, 1}, true, 0.5, {}}}};

TEST(CarriedCsv, LeavesMissingPointsEmpty) {
  EXPECT_EQ(carried_csv(landmarks),
            "label,x,y,z,expected_error,coverage\n"
            "nose,1,2,0.5,0.25,0.750\n"
            "\"a, \"\"b\"\"\",,,,,0.125\n"
            "ear,,,,,1.000\n"
            "tail,,,,,\n"
            "foot,1,1,1,0.5,\n");
}

TEST(IsFinite, AsksThePlaceAndTheErrorAsItIsWritten) {
  EXPECT_TRUE(is_finite(CarriedPoint{{1, 2, 3}, true, 0.5, 1}));
  EXPECT_FALSE(is_finite(CarriedPoint{{1, HUGE_VAL, 3}, true, 0.5, 1}));
  EXPECT_FALSE(is_finite(CarriedPoint{{1, 2, 3}, true, NAN, 1}));
  EXPECT_FALSE(is_finite(CarriedPoint{{1, 2, 3}, true, 1e39, 1}));
}

TEST(CarriedCsv, CanBeCarriedOn) {
  const auto points = read_points_csv(carried_csv(landmarks), "a.csv");
  ASSERT_EQ(points.size(), 5u);
  EXPECT_EQ(points[0].position, Vec3(1, 2, 0.5));
  EXPECT_EQ(points[1].label, "a, \"b\"");
  EXPECT_FALSE(points[1].position);
}

TEST(CarriedPlaces, MarksMissingPointsAsUndefined) {
  const json points = json::parse(markups_text(carried_places(landmarks)))["markups"][0]["controlPoints"];
  EXPECT_EQ(points[0]["position"], json({1.0, 2.0, 0.5}));
  EXPECT_EQ(points[0]["description"], "expected error 0.25, coverage 0.750");
  for (int i : {1, 2, 3}) {
    EXPECT_EQ(points[i]["positionStatus"], "undefined");
    EXPECT_FALSE(points[i].contains("position"));
  }
  EXPECT_EQ(points[1]["description"], "outside the covered part, coverage 0.125");
  EXPECT_EQ(points[2]["description"], "the map folds here, coverage 1.000");
  EXPECT_EQ(points[4]["description"], "expected error 0.5");
}

TEST(CarriedPlaces, KeepWhatTheirFileSaysOfThem) {
  const CarriedPoint point{{1, 2, 0.5}, true, 0.25, 0.75};
  const auto described = [&](const std::string& before) { return carried_places({{"nose", point, before}})[0].description; };
  EXPECT_EQ(described("the tip; of the left one"), "the tip; of the left one; expected error 0.25, coverage 0.750");
  EXPECT_EQ(described("the tip; expected error 3, coverage 0.1"), "the tip; expected error 0.25, coverage 0.750") << "not twice";
  EXPECT_EQ(described("outside the covered part"), "expected error 0.25, coverage 0.750");
  EXPECT_EQ(described("the map folds here, coverage 1.000"), "expected error 0.25, coverage 0.750");
  const MarkupDisplay display = carried_places({{"nose", point, "", {false, true, false}}})[0].display;
  EXPECT_FALSE(display.selected);
  EXPECT_TRUE(display.locked);
  EXPECT_FALSE(display.visible);
}

TEST(CarriedPly, MovesTheVerticesAndKeepsTheTriangles) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const std::string text = carried_ply(mesh, {*landmarks[0].point, *landmarks[2].point, *landmarks[4].point});
  EXPECT_THAT(text, HasSubstr("property float quality\nproperty float expected_error\n"));
  EXPECT_THAT(text, HasSubstr("\n1 2 0.5 0.75 0.25\n7 8 9 0 0.5\n1 1 1 1 0.5\n"));
  EXPECT_EQ(read_ply(text, "a.ply").triangles, mesh.triangles);
}

}  // namespace
}  // namespace homolog
