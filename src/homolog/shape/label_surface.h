// SPDX-License-Identifier: MIT
// The surface of a label of a volume. As a closed mesh in world coordinates it goes the way of every mesh: parts, outputs and turned or
// anisotropic grids need nothing of their own.
#pragma once

#include <optional>
#include <string>

#include "homolog/shape/mesh.h"
#include "homolog/shape/raw_volume.h"

namespace homolog {

/// Which voxels of a label volume are the shape: those of this value; 0 for all that are not 0.
using Label = std::optional<long long>;

inline constexpr long long largest_label = 1'000'000'000'000'000;  ///< that a double holds with all its digits, and a scale in the header

/// The surface of a label. Without one, the volume must hold a single value besides 0. `file` is its name for messages. Throws FileError
/// when values are not whole numbers, when the label is not there or not named (the sentence lists those that are), or when the surface
/// would have too many triangles or be that of noise.
Mesh label_surface(const RawVolume& volume, const Label& label, const std::string& file,
                   std::size_t most_triangles = ReadLimits{}.triangles);

}  // namespace homolog
