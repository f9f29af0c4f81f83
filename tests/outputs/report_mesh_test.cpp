// SPDX-License-Identifier: MIT
// The mesh of a report: the same surface, welded, thinned to what a page can draw, and readable by the page.
#include "homolog/outputs/report_mesh.h"

#include <gtest/gtest.h>

#include <cstring>

#include "shape/meshes.h"

namespace homolog {
namespace {

// Every triangle with corners of its own, as in an STL file.
Mesh torn(const Mesh& mesh) {
  Mesh result;
  for (const auto& triangle : mesh.triangles) {
    const auto n = static_cast<std::uint32_t>(result.vertices.size());
    for (const std::uint32_t corner : triangle) result.vertices.push_back(mesh.vertices[corner]);
    result.triangles.push_back({n, n + 1, n + 2});
  }
  return result;
}

std::string decoded(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t group = 0, bits = 0;
  for (const char c : base64.substr(0, base64.find('='))) {
    group = group << 6 | static_cast<std::uint32_t>(digits.find(c));
    if ((bits += 6) >= 8) bytes += static_cast<char>(group >> (bits -= 8) & 255);
  }
  return bytes;
}

template <class T>
std::vector<T> numbers(const nlohmann::ordered_json& text) {
  const std::string bytes = decoded(text.get<std::string>());
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

TEST(ReportMesh, EqualVerticesBecomeOneAndUnusedOnesGo) {
  Mesh mesh = torn(meshes::box({0, 0, 0}, {1, 2, 3}));
  mesh.vertices.emplace_back(0.5, 0.5, 0.5);
  const ClusteredMesh result = mesh_to_draw(mesh);
  const Mesh& drawn = result.mesh;
  EXPECT_EQ(drawn.vertices.size(), 8u);
  EXPECT_EQ(drawn.triangles.size(), 12u);
  EXPECT_NEAR(meshes::volume(drawn), 6, 1e-12);
  ASSERT_EQ(result.cluster.size(), mesh.vertices.size());
  EXPECT_EQ(result.cluster.back(), ClusteredMesh::nowhere);
  for (std::size_t i = 0; i + 1 < mesh.vertices.size(); ++i) EXPECT_EQ(drawn.vertices[result.cluster[i]], mesh.vertices[i]);
}

TEST(ReportMesh, LargeMeshesAreThinnedAndKeepTheirForm) {
  const Mesh sphere = meshes::sphere(6);
  ASSERT_EQ(sphere.triangles.size(), 32768u);
  const Mesh drawn = mesh_to_draw(sphere, 4000).mesh;
  EXPECT_LE(drawn.triangles.size(), 4000u);
  EXPECT_GE(drawn.triangles.size(), 1000u);  // no thinner than need be
  for (const Vec3& v : drawn.vertices) EXPECT_NEAR(v.norm(), 1, 0.02);
  EXPECT_NEAR(meshes::volume(drawn), 4 * M_PI / 3, 0.05);
  for (const auto& triangle : drawn.triangles) {
    for (const std::uint32_t corner : triangle) EXPECT_LT(corner, drawn.vertices.size());
  }
}

TEST(ReportMesh, SizeAndPlaceDoNotMatter) {
  const Mesh sphere = meshes::sphere(4);
  Mesh far = sphere;
  for (Vec3& v : far.vertices) v = 1024 * v + Vec3(4096, 0, -8192);  // exact in binary
  EXPECT_EQ(mesh_to_draw(sphere, 500).mesh.triangles, mesh_to_draw(far, 500).mesh.triangles);
}

TEST(ReportMesh, ThePageReadsWhatWasMeant) {
  const Mesh box = meshes::box({10, 20, 30}, {11, 22, 33});
  const ClusteredMesh result = mesh_to_draw(box);
  const Mesh& drawn = result.mesh;
  const nlohmann::ordered_json page = mesh_for_page(box, result);
  EXPECT_EQ(page["triangles"], 12);
  EXPECT_EQ(page["centre"], nlohmann::ordered_json({10.5, 21, 31.5}));
  const auto positions = numbers<float>(page["positions"]);
  const auto indices = numbers<std::uint32_t>(page["indices"]);
  ASSERT_EQ(positions.size(), 24u);
  ASSERT_EQ(indices.size(), 36u);
  for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(positions[i], drawn.vertices[i / 3][i % 3] - page["centre"][i % 3].get<double>());
  for (std::size_t i = 0; i < 36; ++i) EXPECT_EQ(indices[i], drawn.triangles[i / 3][i % 3]);
}

TEST(ReportMesh, WeightsAreMeansOverWhatBecameOneVertex) {
  const Mesh box = meshes::box({0, 0, 0}, {1, 1, 1});
  const Mesh mesh = torn(box);
  std::vector<float> weights(mesh.vertices.size());
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = static_cast<float>(mesh.vertices[i].z());
  const ClusteredMesh drawn = mesh_to_draw(mesh);
  const std::string bytes = decoded(weights_for_page(drawn, weights));
  ASSERT_EQ(bytes.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(static_cast<unsigned char>(bytes[i]), drawn.mesh.vertices[i].z() > 0.5 ? 255 : 0);
}

}  // namespace
}  // namespace homolog
