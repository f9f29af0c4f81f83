// SPDX-License-Identifier: MIT
#include "homolog/outputs/landmarks.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "outputs/match_fixture.h"

namespace homolog {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

struct Landmarks : testing::Test {
  Shape model = fixtures::shape("model.off", 1), data = fixtures::shape("data.off", 2);
  Match match = fixtures::family(model, data).matches[0];
};

TEST_F(Landmarks, GiveCorrespondingPointsTheSameLabel) {
  const auto on_model = model_landmarks(match), on_data = data_landmarks(match);
  ASSERT_EQ(on_model.size(), 2u);
  ASSERT_EQ(on_data.size(), 2u);
  EXPECT_EQ(on_model[0].label, "L001");
  for (int i : {0, 1}) {
    EXPECT_EQ(on_model[i].label, on_data[i].label);
    EXPECT_EQ(on_model[i].point.position, match.pairs[i].model_point.position);
    EXPECT_EQ(on_data[i].point.position, match.pairs[i].data_point.position);
    EXPECT_EQ(on_data[i].confidence, match.pairs[i].confidence);
  }
}

TEST_F(Landmarks, OfAShapeAreItsSalientPoints) {
  const auto points = point_landmarks(model);
  ASSERT_EQ(points.size(), model.points.size());
  EXPECT_EQ(points[2].label, "P003");
  EXPECT_FALSE(points[2].confidence);
}

TEST_F(Landmarks, CsvHasOneLineAPointAndLeavesUnknownCellsEmpty) {
  EXPECT_EQ(landmarks_csv(model_landmarks(match)),
            "label,x,y,z,radius,direction_x,direction_y,direction_z,response,confidence\n"
            "L001,0.1,0,0,3,0,1,0,0.75,0.5\n"
            "L002,0,1,0.3333333333333333,1,,,,0.75,0.7\n");
  EXPECT_THAT(landmarks_csv(point_landmarks(model)), HasSubstr("\nP001,0.1,0,0,3,0,1,0,0.75,\n"));
}

TEST_F(Landmarks, CsvOfNothingIsItsHeader) {
  EXPECT_EQ(landmarks_csv({}), "label,x,y,z,radius,direction_x,direction_y,direction_z,response,confidence\n");
}

TEST_F(Landmarks, MarkupsStateSchemaCoordinatesAndStatus) {
  const json markups = json::parse(landmarks_markups(data_landmarks(match)));
  EXPECT_EQ(markups["@schema"],
            "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/markups-schema-v1.0.3.json#");
  ASSERT_EQ(markups["markups"].size(), 1u);
  const json& list = markups["markups"][0];
  EXPECT_EQ(list["type"], "Fiducial");
  EXPECT_EQ(list["coordinateSystem"], "LPS");
  ASSERT_EQ(list["controlPoints"].size(), 2u);
  const json& point = list["controlPoints"][1];
  EXPECT_EQ(point["id"], "2");
  EXPECT_EQ(point["label"], "L002");
  EXPECT_EQ(point["positionStatus"], "defined");
  EXPECT_EQ(point["position"], json({0.0, 2.0, 2.0 / 3}));
  EXPECT_EQ(point["description"], "radius 2, response 0.750, confidence 0.700");
}

TEST_F(Landmarks, MarkupsOfNothingAreAnEmptyList) {
  const json markups = json::parse(landmarks_markups({}));
  EXPECT_EQ(markups["markups"][0]["controlPoints"], json::array());
  EXPECT_THAT(landmarks_markups({}), StartsWith("{"));
}

}  // namespace
}  // namespace homolog
