// SPDX-License-Identifier: MIT
// What protects the machine from a file: how much is read, how many points are matched, how much memory is taken.
#pragma once

#include <CLI/CLI.hpp>

#include "homolog/describe/shape.h"
#include "homolog/shape/read_mesh.h"

namespace homolog::cli {

struct Limits {
  ReadLimits file;
  std::size_t points = 2000;  ///< of a shape; an animal has thirty, and the time of a match grows with the square
};

/// --max-bytes, --max-triangles, --max-voxels and --max-memory; the last takes effect when it is read.
void add_reading_limits(CLI::App& verb, ReadLimits& limits);

/// The same and --max-points.
void add_limit_options(CLI::App& verb, Limits& limits);

/// Throws ShapeError when the shape has more salient points than may be.
void check_points(const Shape& shape, const Limits& limits);

}  // namespace homolog::cli
