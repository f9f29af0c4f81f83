// SPDX-License-Identifier: MIT
// What the two kinds of VTK file have in common: points, and cells that name them. They are read by ourselves: VTK's own library is a
// hundred megabytes with as much again below it, and nothing smaller in Debian reads both.
#pragma once

#include <string>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

/// Numbers as the file has them; a double holds all that a file can need exactly.
struct VtkCells {
  std::vector<double> corners;  ///< numbers of points
  std::vector<double> ends;     ///< cell i ends before corner ends[i], where the next one begins
  std::vector<double> types;    ///< of every cell, as VTK numbers them
};

inline constexpr double vtk_strip = 6, vtk_polygon = 7;

/// Cells that are all of one type.
VtkCells cells_of_type(double type, std::vector<double> corners, std::vector<double> ends);

/// Adds points, three numbers each, and the triangles of cells on them; vertices and lines add none. Throws FileError for what does not
/// exist and for cells that are not flat.
void append_vtk(Mesh& mesh, const std::vector<double>& points, const std::vector<VtkCells>& cells, const std::string& file);

}  // namespace homolog
