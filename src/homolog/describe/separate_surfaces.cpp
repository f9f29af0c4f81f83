// SPDX-License-Identifier: MIT
#include "homolog/describe/separate_surfaces.h"

#include <algorithm>
#include <cmath>

#include "homolog/shape/nearest_points.h"

namespace homolog {
namespace {

constexpr std::size_t least_samples = 24;  // fewer show no form

// For each node on the skin the first one of its piece.
std::vector<int> pieces_of(const Body& body) {
  std::vector<int> piece(body.surface_count, -1);
  const int count = static_cast<int>(piece.size());
  for (int i = 0; i < count; ++i) {
    if (piece[i] >= 0) continue;
    for (int j = i; j < count; ++j) {
      if (std::isfinite(body.ways(i, j))) piece[j] = i;
    }
  }
  return piece;
}

// The body of these nodes, which are in ascending order.
Body part_of(const Body& whole, const std::vector<int>& nodes) {
  std::vector<int> number(whole.nodes.size(), -1);
  for (std::size_t k = 0; k < nodes.size(); ++k) number[nodes[k]] = static_cast<int>(k);
  Body body;
  for (const int node : nodes) {
    body.nodes.push_back(whole.nodes[node]);
    body.normals.push_back(whole.normals[node]);
    std::vector<int>& list = body.neighbours.emplace_back();
    for (const int other : whole.neighbours[node]) {
      if (number[other] >= 0) list.push_back(number[other]);
    }
    if (node < static_cast<int>(whole.surface_count)) ++body.surface_count;
  }
  body.spacing = whole.spacing;
  body.ways = whole.ways(nodes, nodes);
  settle_body(body);
  return body;
}

}  // namespace

std::vector<std::vector<int>> separate_surfaces(const std::vector<SurfaceSample>& surface, const Body& body, std::size_t most) {
  const std::vector<int> piece = pieces_of(body);
  if (std::all_of(piece.begin(), piece.end(), [](int p) { return p == 0; })) return {};
  std::vector<std::vector<int>> surfaces(piece.size());
  const NearestPoints skin({body.nodes.begin(), body.nodes.begin() + static_cast<std::ptrdiff_t>(body.surface_count)});
  for (std::size_t i = 0; i < surface.size(); ++i) {
    surfaces[piece[skin.nearest(surface[i].position, 1).front().number]].push_back(static_cast<int>(i));
  }
  std::erase_if(surfaces, [](const auto& samples) { return samples.size() < least_samples; });
  if (surfaces.size() < 2) return {};
  std::stable_sort(surfaces.begin(), surfaces.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  surfaces.resize(std::min(surfaces.size(), most));
  return surfaces;
}

Piece piece_of(const Shape& whole, const std::vector<int>& samples) {
  const auto skin_end = std::lower_bound(samples.begin(), samples.end(), static_cast<int>(whole.body.surface_count));
  std::vector<int> nodes(samples.begin(), skin_end);
  Piece piece;
  for (int point = 0; point < static_cast<int>(whole.points.size()); ++point) {
    const auto node = static_cast<int>(whole.body.point_node(point));
    if (nodes.empty() || !std::isfinite(whole.body.ways(nodes.front(), node))) continue;
    nodes.push_back(node);
    piece.points.push_back(point);
  }
  Shape& shape = piece.shape;
  shape.name = whole.name;
  shape.interior = whole.interior;
  for (const int point : piece.points) {
    shape.points.push_back(whole.points[point]);
    shape.descriptors.push_back(whole.descriptors[point]);
  }
  for (const int i : samples) {
    shape.surface.push_back(whole.surface[i]);
    shape.thickness.push_back(whole.thickness[i]);
  }
  shape.diagonal = diagonal_of(shape.surface);
  shape.surface_blocks = make_blocks(shape.surface);
  shape.surface_spacing = typical_spacing(positions_of(shape.surface));
  shape.body = part_of(whole.body, nodes);
  shape.ends = find_ends(shape.body);
  shape.inner_distance = whole.inner_distance(piece.points, piece.points);
  return piece;
}

}  // namespace homolog
