// SPDX-License-Identifier: MIT
// The XML files of VTK: polygonal data (.vtp) and unstructured grids (.vtu), with arrays as text, base64 or raw bytes, plain or compressed
// by zlib. Ours, for the reason in vtk_cells.h; the XML is expat's.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/mesh.h"

namespace homolog {

/// Whether content begins as the XML files of VTK do.
bool is_vtp(std::string_view content);

/// The polygons and triangle strips, or the flat cells of a grid, of all pieces; the points keep their order. Values of points and cells
/// are left out. Throws FileError for other data, more than three times as many points as `most_triangles`, what is missing, points that do
/// not exist, and numbers that are not finite.
Mesh read_vtp(std::string_view content, const std::string& file, std::size_t most_triangles);

}  // namespace homolog
