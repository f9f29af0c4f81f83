// SPDX-License-Identifier: MIT
// From a file's name to a described shape, with progress, warnings and errors that name the file.
#pragma once

#include <string>

#include "console.h"
#include "homolog/homolog.h"
#include "homolog/match/coverage.h"
#include "input_limits.h"

namespace homolog::cli {

struct DescribedFile {
  Mesh mesh;
  Shape shape;

  MeshedShape meshed() const { return {mesh, shape}; }
};

/// `label`: which label of a volume. Throws FileError or ShapeError, also for what is beyond the limits.
DescribedFile describe_file(const std::string& path, const std::optional<Box>& part, const Params& params, const Limits& limits,
                            Console& console, const Label& label = {});

/// That a shape has no salient points, and what to do, as a sentence.
std::string no_points(const Shape& shape);

/// What help says about the files that a verb reads.
inline constexpr const char* kShapeHelp =
    "a mesh (OFF, OBJ, PLY, STL, glTF, ...), a label volume (NIfTI, NRRD, MetaImage) or a point cloud with normals (PLY, XYZ)";

}  // namespace homolog::cli
