// SPDX-License-Identifier: MIT
// Which boxes of very many may hold another one, without a look at all of them.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

class NestedBoxes {
 public:
  explicit NestedBoxes(const std::vector<Box>& boxes);

  /// The numbers of all boxes that hold the place, and of some that do not; in order, each once.
  std::vector<std::uint32_t> around(const Vec3& place) const;

 private:
  std::vector<int> sizes_;                                      // of boxes, as powers of two
  std::vector<std::pair<std::uint64_t, std::uint32_t>> cells_;  // of grids as wide as boxes of a size need; sorted
};

}  // namespace homolog
