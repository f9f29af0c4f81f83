// SPDX-License-Identifier: MIT
// What a slicer keeps beside a 3MF model of its own: which triangles of an object are no part of the solid.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "homolog/shape/mesh.h"
#include "homolog/shape/zip_archive.h"

namespace homolog {

/// First and last, both included.
struct TriangleRange {
  std::size_t first, last;
};

/// PrusaSlicer keeps all volumes of an object in one mesh, and in `Metadata/Slic3r_PE_model.config` which of its triangles are modifiers,
/// negative volumes and supports. By the number of the object; none where there is no such file. Throws FileError when it is damaged, or
/// longer than `most`.
std::map<std::string, std::vector<TriangleRange>> no_solid_parts(const ZipArchive& archive, const std::string& file, std::uint64_t most);

/// Without the triangles of these parts. Throws FileError for a part beyond the mesh.
void leave_out(Mesh& mesh, const std::vector<TriangleRange>& parts, const std::string& file);

}  // namespace homolog
