// SPDX-License-Identifier: MIT
#include "homolog/outputs/report_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace homolog {
namespace {

static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");

struct KeyedVertex {
  std::uint64_t cell;
  std::uint32_t vertex;
  auto operator<=>(const KeyedVertex&) const = default;
};

/// The vertices that triangles use, sorted by the cell of a grid in which they lie.
std::vector<KeyedVertex> sort_into_cells(const Mesh& mesh, const Vec3& origin, double cell) {
  std::vector<bool> used(mesh.vertices.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) used[corner] = true;
  }
  std::vector<KeyedVertex> keyed;
  for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
    if (!used[i]) continue;
    const Vec3 v = (mesh.vertices[i] - origin) / cell;
    const auto part = [&](int axis) { return static_cast<std::uint64_t>(v[axis]); };
    keyed.push_back({part(2) << 42 | part(1) << 21 | part(0), i});
  }
  std::sort(keyed.begin(), keyed.end());
  return keyed;
}

/// All vertices of a cell become their mean; triangles that collapse are dropped. At most 2^21 cells along an axis.
DrawnMesh cluster(const Mesh& mesh, double cell) {
  const std::vector<KeyedVertex> keyed = sort_into_cells(mesh, bounding_box(mesh).min, cell);
  DrawnMesh drawn{{}, std::vector<std::uint32_t>(mesh.vertices.size(), DrawnMesh::nowhere)};
  Mesh& result = drawn.mesh;
  std::vector<std::uint32_t>& cluster_of = drawn.drawn_vertex;
  for (std::size_t begin = 0, end = 0; begin < keyed.size(); begin = end) {
    Vec3 sum = Vec3::Zero();
    for (; end < keyed.size() && keyed[end].cell == keyed[begin].cell; ++end) {
      sum += mesh.vertices[keyed[end].vertex];
      cluster_of[keyed[end].vertex] = static_cast<std::uint32_t>(result.vertices.size());
    }
    result.vertices.push_back(sum / static_cast<double>(end - begin));
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array<std::uint32_t, 3> triangle{cluster_of[a], cluster_of[b], cluster_of[c]};
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]) result.triangles.push_back(triangle);
  }
  return drawn;
}

template <class T>
std::string base64(const std::vector<T>& values) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto bytes = std::as_bytes(std::span(values));
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace

DrawnMesh mesh_to_draw(const Mesh& mesh, std::size_t max_triangles) {
  const double diagonal = bounding_box(mesh).diagonal();
  DrawnMesh drawn = cluster(mesh, diagonal * 1e-6);
  for (double cell = diagonal / 400; drawn.mesh.triangles.size() > max_triangles; cell *= 1.2) drawn = cluster(mesh, cell);
  return drawn;
}

nlohmann::ordered_json mesh_for_page(const Mesh& mesh, const DrawnMesh& drawn) {
  const Box box = bounding_box(mesh);
  const Vec3 centre = (box.min + box.max) / 2;
  std::vector<float> positions;
  for (const Vec3& v : drawn.mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) positions.push_back(static_cast<float>(v[axis] - centre[axis]));
  }
  return {{"centre", {centre.x(), centre.y(), centre.z()}},
          {"positions", base64(positions)},
          {"indices", base64(drawn.mesh.triangles)},
          {"triangles", mesh.triangles.size()}};
}

std::string weights_for_page(const DrawnMesh& drawn, const std::vector<float>& weights) {
  std::vector<double> sums(drawn.mesh.vertices.size(), 0), counts(sums);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (drawn.drawn_vertex[i] == DrawnMesh::nowhere) continue;
    sums[drawn.drawn_vertex[i]] += weights[i];
    ++counts[drawn.drawn_vertex[i]];
  }
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < sums.size(); ++i) bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * sums[i] / counts[i])));
  return base64(bytes);
}

}  // namespace homolog
