// SPDX-License-Identifier: MIT
#include "homolog/outputs/parts.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "homolog/outputs/json_text.h"
#include "homolog/outputs/report_mesh.h"
#include "homolog/shape/read_ply.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;

const Mesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {9, 9, 9}}, {{0, 1, 2}, {0, 2, 3}, {4, 2, 3}}};

std::string parts_json(const MeshedShape& model, const MeshedShape& data, const std::vector<MatchParts>& parts) {
  return text_of([&](const Sink& sink) { write_parts_json(model, data, parts, sink); });
}

TEST(PartsJson, HasAWeightForEveryVertexAndSampleOfEveryMatch) {
  Shape model, data;
  model.name = "model.off";
  model.surface = {{{0.5, 0.25, 0}, Vec3::UnitZ()}};
  const PartWeights on_model{{0, 1, 0.12345f, 1, 1, 0}, {0.5f}}, on_data{{1, 1, 1, 1, 1, 1}, {}};
  const ordered_json json = ordered_json::parse(parts_json({square, model}, {square, data}, {{on_model, on_data}, {on_model, on_data}}));
  EXPECT_EQ(json["format"], "homolog-parts");
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["model"], ordered_json::parse(R"({"file": "model.off", "vertices": 6, "samples": [[0.5, 0.25, 0.0]]})"));
  ASSERT_EQ(json["matches"].size(), 2u);
  EXPECT_EQ(json["matches"][1]["model"]["vertices"], ordered_json::parse("[0.0, 1.0, 0.123, 1.0, 1.0, 0.0]"));
  EXPECT_EQ(json["matches"][1]["model"]["samples"], ordered_json::parse("[0.5]"));
  EXPECT_EQ(json["matches"][0]["data"]["vertices"].size(), 6u);
}

TEST(PartsJson, IsLaidOutAsAllOurJson) {
  Shape model, data;
  for (int i = 0; i < 100; ++i) model.surface.push_back({{i / 7.0, 0.25, -i / 3.0}, Vec3::UnitZ()});
  data.surface = model.surface;
  std::vector<float> weights;
  for (int i = 0; i < 500; ++i) weights.push_back(static_cast<float>(i % 100) / 99);
  const PartWeights on_model{weights, std::vector<float>(100, 1)}, on_data{{1, 0, 1, 0.5f, 1, 1}, std::vector<float>(100, 0.0004f)};
  const std::string text = parts_json({square, model}, {square, data}, {{on_model, on_data}, {on_data, on_model}});
  EXPECT_EQ(text, json_text(ordered_json::parse(text)));
  const std::string none = parts_json({square, model}, {square, data}, {});
  EXPECT_EQ(none, json_text(ordered_json::parse(none)));
}

TEST(PartPly, ShowsWeightsAsColoursAndAsNumbers) {
  const std::string text = text_of([](const Sink& sink) { write_part_ply(square, {0, 1, 0.5f, 0, 0, 0}, sink); });
  EXPECT_THAT(text, HasSubstr("\n0 0 0 204 212 219 0\n1 0 0 51 168 158 1\n1 1 0 128 190 189 0.5\n"));
  EXPECT_EQ(read_ply(text, "part.ply").vertices.size(), square.vertices.size());
}

TEST(WeightsForPage, AreMeansOverWhatBecomesOneVertex) {
  const ClusteredMesh drawn = mesh_to_draw(square);
  ASSERT_EQ(drawn.mesh.vertices.size(), 4u);
  EXPECT_EQ(drawn.cluster[1], drawn.cluster[4]);
  EXPECT_EQ(drawn.cluster[5], ClusteredMesh::nowhere);
  EXPECT_EQ(weights_for_page(drawn, {0, 1, 0, 0, 0, 1}).size(), 8u);  // four bytes
  EXPECT_EQ(weights_for_page(drawn, {1, 1, 1, 1, 1, 0}), "/////w==");
}

}  // namespace
}  // namespace homolog
