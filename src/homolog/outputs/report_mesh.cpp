// SPDX-License-Identifier: MIT
#include "homolog/outputs/report_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace homolog {
namespace {

static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");

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

ClusteredMesh mesh_to_draw(const Mesh& mesh, std::size_t max_triangles) {
  const double diagonal = bounding_box(mesh).diagonal();
  ClusteredMesh drawn = cluster_vertices(mesh, diagonal * 1e-6);
  for (double cell = diagonal / 400; drawn.mesh.triangles.size() > max_triangles;) {
    drawn = cluster_vertices(mesh, cell);
    const double times = std::sqrt(static_cast<double>(drawn.mesh.triangles.size()) / static_cast<double>(max_triangles));
    cell *= std::max(1.2, 0.8 * times);  // nearly as much coarser as must be
  }
  return drawn;
}

nlohmann::ordered_json mesh_for_page(const Mesh& mesh, const ClusteredMesh& drawn) {
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

std::string weights_for_page(const ClusteredMesh& drawn, const std::vector<float>& weights) {
  std::vector<double> sums(drawn.mesh.vertices.size(), 0), counts(sums);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (drawn.cluster[i] == ClusteredMesh::nowhere) continue;
    sums[drawn.cluster[i]] += weights[i];
    ++counts[drawn.cluster[i]];
  }
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < sums.size(); ++i) bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * sums[i] / counts[i])));
  return base64(bytes);
}

}  // namespace homolog
