// SPDX-License-Identifier: MIT
#include "homolog/outputs/match_json.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "outputs/match_fixture.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;
using testing::ElementsAre;

std::vector<std::string> keys(const ordered_json& object) {
  std::vector<std::string> names;
  for (const auto& item : object.items()) names.push_back(item.key());
  return names;
}

struct MatchJson : testing::Test {
  Shape model = fixtures::shape("model.off", 1), data = fixtures::shape("data.off", 2);
  Family family = fixtures::family(model, data);
  Params params;
  ordered_json json = ordered_json::parse(match_json(model, data, family, params));
};

TEST_F(MatchJson, HasTheKeysOfTheFormatInTheirOrder) {
  EXPECT_THAT(keys(json), ElementsAre("format", "version", "program", "parameters", "model", "data", "counts", "matches"));
  EXPECT_THAT(keys(json["model"]), ElementsAre("file", "diagonal", "points"));
  EXPECT_THAT(keys(json["data"]["points"][0]), ElementsAre("position", "radius", "direction", "response"));
  EXPECT_THAT(keys(json["counts"]), ElementsAre("candidates", "seeds", "verified"));
  EXPECT_THAT(keys(json["matches"][0]), ElementsAre("pairs", "confidence", "handedness", "scale", "data_from_model", "bending", "chamfer",
                                                    "model_coverage", "data_coverage", "warp"));
  EXPECT_THAT(keys(json["matches"][0]["pairs"][0]), ElementsAre("model", "data", "descriptor_distance", "confidence"));
  EXPECT_THAT(keys(json["matches"][0]["warp"]), ElementsAre("kernel", "centres", "weights", "affine"));
}

TEST_F(MatchJson, NamesFormatVersionAndProgram) {
  EXPECT_EQ(json["format"], "homolog-match");
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["program"], "homolog " HOMOLOG_VERSION);
  EXPECT_EQ(json["data"]["file"], "data.off");
}

TEST_F(MatchJson, ListsEveryParameterByName) {
  std::vector<std::string> names;
  for (const ParameterInfo& info : parameter_table()) names.push_back(info.name);
  EXPECT_EQ(keys(json["parameters"]), names);
  EXPECT_EQ(json["parameters"]["resolution"], params.voxel.resolution);
  EXPECT_EQ(json["parameters"]["sigma0"], params.salient.sigma0);
  EXPECT_EQ(json["parameters"]["mirror"], "allow");
}

TEST_F(MatchJson, FollowedPointsComeAfterTheDatasOwn) {
  const std::size_t own = data.points.size();
  family.followed.push_back(model.points[1]);
  const ordered_json longer = ordered_json::parse(match_json(model, data, family, params));
  ASSERT_EQ(longer["data"]["points"].size(), own + 1);
  EXPECT_EQ(longer["data"]["points"][own], longer["model"]["points"][1]);
  EXPECT_EQ(longer["model"], json["model"]);
}

TEST_F(MatchJson, KeepsNumbersToTheLastBit) {
  EXPECT_EQ(json["model"]["points"][2]["position"][2].get<double>(), model.points[2].position.z());
  EXPECT_EQ(json["matches"][0]["chamfer"].get<double>(), family.matches[0].chamfer);
}

TEST_F(MatchJson, WritesMatricesRowByRow) {
  EXPECT_EQ(json["matches"][0]["data_from_model"],
            ordered_json::parse("[[2.0,0.0,0.0,0.0],[0.0,2.0,0.0,0.0],[0.0,0.0,2.0,7.0],[0.0,0.0,0.0,1.0]]"));
  EXPECT_EQ(json["matches"][0]["warp"]["affine"], ordered_json::parse("[[1.0,0.0,0.0,0.0],[0.0,1.0,0.0,0.0],[0.0,0.0,1.0,0.0]]"));
  EXPECT_EQ(json["matches"][0]["warp"]["kernel"], "r");
  EXPECT_EQ(json["matches"][0]["handedness"], "proper");
}

TEST_F(MatchJson, GivesPointsWithoutDirectionAZeroVector) {
  EXPECT_EQ(json["model"]["points"][0]["direction"], ordered_json::parse("[0.0,1.0,0.0]"));
  EXPECT_EQ(json["model"]["points"][2]["direction"], ordered_json::parse("[0.0,0.0,0.0]"));
}

TEST_F(MatchJson, RepeatsItsBytes) { EXPECT_EQ(match_json(model, data, family, params), match_json(model, data, family, params)); }

TEST_F(MatchJson, WritesAnEmptyListWhenNothingWasFound) {
  family.matches.clear();
  const ordered_json empty = ordered_json::parse(match_json(model, data, family, params));
  EXPECT_EQ(empty["matches"], ordered_json::array());
  EXPECT_EQ(empty["counts"]["candidates"], 12);
}

TEST_F(MatchJson, StaysUtf8WhateverTheFileIsCalled) {
  model.name = "b\xffr \"1\".off";
  const ordered_json odd = ordered_json::parse(match_json(model, data, family, params));
  EXPECT_EQ(odd["model"]["file"], "b\xef\xbf\xbdr \"1\".off");
}

TEST(PointsJson, HoldsTheShapeAsMatchJsonDoes) {
  const Shape shape = fixtures::shape("model.off", 1);
  const ordered_json json = ordered_json::parse(points_json(shape, {}));
  EXPECT_THAT(keys(json), ElementsAre("format", "version", "program", "parameters", "shape"));
  EXPECT_EQ(json["format"], "homolog-points");
  EXPECT_EQ(json["shape"], ordered_json::parse(match_json(shape, shape, {}, {}))["model"]);
}

TEST(PointsJson, HasAnEmptyListForAShapeWithoutPoints) {
  Shape shape = fixtures::shape("model.off", 1);
  shape.points.clear();
  EXPECT_EQ(ordered_json::parse(points_json(shape, {}))["shape"]["points"], ordered_json::array());
}

}  // namespace
}  // namespace homolog
