// SPDX-License-Identifier: MIT
#include "homolog/outputs/dense_files.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "homolog/shape/read_ply.h"

namespace homolog {
namespace {

const Mesh square{{{0, 0, 0}, {2, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};

/// Vertex 0 in the middle of the first edge, vertex 1 nowhere, vertex 2 on a corner.
DenseMap some_places() {
  DenseMap map;
  map.places.resize(3);
  map.places[0] = {0, {0.5, 0.5, 0}, {1, 0, 0}, 0.75};
  map.places[2] = {0, {0, 0, 1}, {0, 4, 0}, 1};
  map.placed = 2;
  return map;
}

TEST(DenseCsv, LeavesTheCellsOfWhatHasNoPlaceEmpty) {
  EXPECT_EQ(dense_csv(some_places()),
            "vertex,triangle,b0,b1,b2,x,y,z,confidence\n"
            "0,0,0.5,0.5,0,1,0,0,0.7500\n"
            "1,,,,,,,,0\n"
            "2,0,0,0,1,0,4,0,1.0000\n");
}

TEST(PositionColours, GrowAlongTheBox) {
  const auto colours = position_colours(square);
  EXPECT_EQ(colours[0], (Colour{40, 40, 40}));
  EXPECT_EQ(colours[1], (Colour{255, 40, 40}));
  EXPECT_EQ(colours[2], (Colour{40, 255, 40}));
}

TEST(CarriedColours, AreThoseOfThePlaces) {
  const auto carried = carried_colours(some_places(), square, position_colours(square));
  EXPECT_EQ(carried[0], (Colour{148, 40, 40}));
  EXPECT_EQ(carried[1], (Colour{128, 128, 128}));
  EXPECT_EQ(carried[2], (Colour{40, 255, 40}));
}

TEST(DensePly, HoldsPlacesAndConfidenceAndIsReadAgain) {
  const std::string text = dense_ply(square, some_places(), position_colours(square));
  EXPECT_NE(text.find("property float place_z\nproperty float quality\n"), std::string::npos);
  EXPECT_NE(text.find("\n0 0 0 40 40 40 1 0 0 0.75\n2 0 0 255 40 40 nan nan nan 0\n"), std::string::npos) << text;
  EXPECT_EQ(read_ply(text, "own.ply").vertices, square.vertices);
}

TEST(DenseJson, CountsBothWays) {
  const StoredFamily family{{"a.off"}, {"b.off"}, {}};
  const auto json = nlohmann::json::parse(dense_json(family, 2, {some_places(), {}, {}}));
  EXPECT_EQ(json["format"], "homolog-dense");
  EXPECT_EQ(json["match"], 2);
  EXPECT_EQ(json["data_from_model"]["placed"], 2);
  EXPECT_EQ(json["data_from_model"]["vertices"], 3);
  EXPECT_EQ(json["data_from_model"]["to"], "b.off");
  EXPECT_EQ(json["model_from_data"]["vertices"], 0);
}

}  // namespace
}  // namespace homolog
