// SPDX-License-Identifier: MIT
// How often a surface winds around a point, also where it has holes: the solid angle that it fills, as a share of the whole [barill2018].
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

class WindingNumber {
 public:
  /// Of triangles whose front is outside. From far away the area vector of a group of them stands for the group.
  WindingNumber(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles);

  /// The winding number around x. Inside a closed surface 1, outside 0, to within 0.05.
  double at(const Vec3& x) const;

  /// How many groups and triangles at() looks at.
  std::size_t looked_at(const Vec3& x) const;

 private:
  struct Node {
    Vec3 centre, area;           ///< mean place, weighted by area, and sum of the area vectors
    double reach;                ///< distance of the farthest corner from the centre
    std::uint32_t first, count;  ///< of corners_, for a leaf; count 0: the children are the next node and node `first`
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t end);
  double solid_angle(std::uint32_t number, const Vec3& x) const;
  std::size_t looked_at(std::uint32_t number, const Vec3& x) const;

  std::vector<std::array<Vec3, 3>> corners_;  ///< of the triangles, leaf by leaf
  std::vector<Node> nodes_;
};

}  // namespace homolog
