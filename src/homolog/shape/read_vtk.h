// SPDX-License-Identifier: MIT
// Legacy VTK files, ascii and binary, of versions 1 to 5 (VTK's "File Formats"). Ours, for the reason in vtk_cells.h.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/mesh.h"

namespace homolog {

/// Whether content begins as legacy VTK files do.
bool is_vtk(std::string_view content);

/// The polygons and triangle strips of polygonal data, or the flat cells of an unstructured grid; the points keep their order. Values of
/// points and cells are left out. Throws FileError for other data, what is missing, points that do not exist, and numbers that are not
/// finite.
Mesh read_vtk(std::string_view content, const std::string& file);

}  // namespace homolog
