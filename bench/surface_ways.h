// SPDX-License-Identifier: MIT
// Ways along a surface: how far two of its places are apart for who walks on it.
#pragma once

#include <cstdint>
#include <vector>

#include "homolog/shape/nearest_surface.h"

namespace homolog::bench {

double area_of(const Mesh& mesh);

/// Shortest ways along edges and, where two triangles laid flat let a straight line through, from corner to opposite corner (Dijkstra):
/// an upper bound, some per cent too long.
class SurfaceWays {
 public:
  explicit SurfaceWays(const Mesh& mesh);

  /// From a place to every vertex; infinite to other components.
  std::vector<double> from(const SurfacePlace& place) const;
  /// The rest of the way, to a place; `ways` are those from `start`.
  double to(const SurfacePlace& place, const SurfacePlace& start, const std::vector<double>& ways) const;

 private:
  struct Link {
    std::uint32_t vertex;
    double length;
  };
  void link(std::uint32_t a, std::uint32_t b, double length);
  void link_across(std::uint32_t a, std::uint32_t b, std::uint32_t left, std::uint32_t right);

  Mesh mesh_;
  std::vector<std::vector<Link>> links_;  ///< of every vertex
};

}  // namespace homolog::bench
