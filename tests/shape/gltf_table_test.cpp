// SPDX-License-Identifier: MIT
#include "homolog/shape/gltf_table.h"

#include <gmock/gmock.h>

#include "homolog/outputs/glb.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

std::optional<std::string> nothing(const std::string&) { return {}; }

TEST(ReadGltfFile, ReadsABufferWithinTheText) {
  const GltfFile gltf =
      read_gltf_file(R"({"buffers": [{"byteLength": 5, "uri": "data:application/octet-stream;base64,AQIDBAU="}]})", "a.gltf", nothing);
  EXPECT_EQ(gltf.buffers.at(0), "\1\2\3\4\5");
}

TEST(ReadGltfTable, PutsSparseRowsIntoTheOthers) {
  GltfContent content;
  add_table(content, Floats{1, 2, 3}, 1, GltfTarget::none);
  add_table(content, std::vector<std::uint16_t>{2}, 1, GltfTarget::none);
  add_table(content, Floats{9}, 1, GltfTarget::none);
  content.accessors[0]["sparse"] = {
      {"count", 1}, {"indices", {{"bufferView", 1}, {"componentType", 5123}}}, {"values", {{"bufferView", 2}}}};
  const std::string glb = glb_bytes(gltf_document(ordered_json::object(), content), content);
  EXPECT_EQ(read_gltf_table(read_gltf_file(glb, "a.glb", nothing), 0, {"it", {1}, {}}).values, (std::vector<double>{1, 2, 9}));
}

}  // namespace
}  // namespace homolog
