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

}  // namespace

std::vector<std::vector<SurfaceSample>> separate_surfaces(const std::vector<SurfaceSample>& surface, const Body& body, std::size_t most) {
  const std::vector<int> piece = pieces_of(body);
  if (std::all_of(piece.begin(), piece.end(), [](int p) { return p == 0; })) return {};
  std::vector<std::vector<SurfaceSample>> surfaces(piece.size());
  const NearestPoints skin({body.nodes.begin(), body.nodes.begin() + static_cast<std::ptrdiff_t>(body.surface_count)});
  for (const SurfaceSample& s : surface) surfaces[piece[skin.nearest(s.position, 1).front().number]].push_back(s);
  std::erase_if(surfaces, [](const auto& samples) { return samples.size() < least_samples; });
  if (surfaces.size() < 2) return {};
  std::stable_sort(surfaces.begin(), surfaces.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  surfaces.resize(std::min(surfaces.size(), most));
  return surfaces;
}

}  // namespace homolog
