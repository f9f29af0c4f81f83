// SPDX-License-Identifier: MIT
// How far places of a surface lie apart along it.
#pragma once

#include <cstdint>
#include <vector>

#include "homolog/shape/nearest_surface.h"

namespace homolog {

class SkinRoutes {
 public:
  explicit SkinRoutes(const Mesh& mesh);

  /// Whether a way along the edges of the surface, from one place to the other, is at most `limit` long. Triangles that touch are near; so
  /// are places of different components that lie within `limit` straight, for pieces of one body may overlap.
  bool within(const SurfacePlace& from, const SurfacePlace& to, double limit) const;

 private:
  const Mesh& mesh_;
  std::vector<std::uint32_t> first_;  ///< of every vertex, the first one in its place
  std::vector<std::uint32_t> begin_;  ///< of the neighbours of every vertex
  std::vector<std::uint32_t> neighbours_;
  std::vector<std::uint32_t> component_;  ///< of every vertex
};

}  // namespace homolog
