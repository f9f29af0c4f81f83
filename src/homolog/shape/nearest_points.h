// SPDX-License-Identifier: MIT
// The points of a set that are nearest to a place.
#pragma once

#include <cstdint>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

class NearestPoints {
 public:
  explicit NearestPoints(std::vector<Vec3> points);

  struct Neighbour {
    double square_distance;
    std::uint32_t number;
    auto operator<=>(const Neighbour&) const = default;
  };

  /// The `count` points nearest to x, nearest first and equally near ones by number; all when there are fewer.
  std::vector<Neighbour> nearest(const Vec3& x, std::size_t count) const;

 private:
  struct Node {
    Box box;
    std::uint32_t first, count;  ///< of order_, for a leaf; count 0: the children are the next node and node `first`
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t end);
  void look(std::uint32_t number, const Vec3& x, std::size_t count, std::vector<Neighbour>& heap) const;

  std::vector<Vec3> points_;
  std::vector<std::uint32_t> order_;  ///< points, leaf by leaf
  std::vector<Node> nodes_;
};

}  // namespace homolog
