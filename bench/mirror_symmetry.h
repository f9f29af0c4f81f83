// SPDX-License-Identifier: MIT
// The left-right symmetry of a mesh that stands symmetric about a plane across a coordinate axis, as rest poses do.
#pragma once

#include <cstddef>
#include <vector>

#include "homolog/base/vec.h"

namespace homolog::bench {

/// For each of the first `count` vertices the one at its mirrored place. Empty unless the mirrored vertices fall on vertices
/// within 1 % of the extent (root mean square).
std::vector<int> mirror_symmetry(const std::vector<Vec3>& vertices, std::size_t count);

}  // namespace homolog::bench
