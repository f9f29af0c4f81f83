// SPDX-License-Identifier: MIT
#include "homolog/shape/vtk_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "homolog/base/errors.h"
#include "homolog/shape/polygon.h"

namespace homolog {
namespace {

using Corners = std::vector<std::uint32_t>;

constexpr double last_line = 4, triangle = 5, pixel = 8, quad = 9;

Corners corners_of(const VtkCells& cells, std::size_t from, std::size_t to, std::size_t first, std::size_t points,
                   const std::string& file) {
  Corners corners;
  for (std::size_t i = from; i < to; ++i) {
    const double corner = cells.corners[i];
    if (!(corner >= 0 && corner < static_cast<double>(points)) || corner != std::floor(corner)) {
      throw FileError(
          fmt::format("{}: a cell names point {}, but there are {}, counted from 0; the file is damaged", file, corner, points));
    }
    corners.push_back(static_cast<std::uint32_t>(first + static_cast<std::size_t>(corner)));
  }
  return corners;
}

void append_cell(Mesh& mesh, double type, Corners corners, const std::string& file) {
  if (type == vtk_strip) {
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
      mesh.triangles.push_back({corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
    }
  } else if (type == triangle || type == vtk_polygon || type == quad || type == pixel) {
    if (type == pixel && corners.size() == 4) std::swap(corners[2], corners[3]);
    append_polygon(mesh, std::move(corners));
  } else if (!(type >= 0 && type <= last_line)) {
    throw FileError(fmt::format(
        "{}: it holds cells that are no flat polygons (type {}); extract their surface, in ParaView, say, and save that", file, type));
  }
}

}  // namespace

VtkCells cells_of_type(double type, std::vector<double> corners, std::vector<double> ends) {
  std::vector<double> types(ends.size(), type);
  return {std::move(corners), std::move(ends), std::move(types)};
}

void append_vtk(Mesh& mesh, const std::vector<double>& points, const std::vector<VtkCells>& cells, const std::string& file) {
  const std::size_t first = mesh.vertices.size(), count = points.size() / 3;
  for (std::size_t i = 0; i < count; ++i) {
    mesh.vertices.emplace_back(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
    if (!mesh.vertices.back().allFinite()) {
      throw FileError(fmt::format("{}, point {}: a coordinate is not a finite number; the file is damaged", file, i));
    }
  }
  for (const VtkCells& some : cells) {
    if (some.types.size() != some.ends.size()) {
      throw FileError(
          fmt::format("{}: it has {} cells, but {} types of cells; the file is damaged", file, some.ends.size(), some.types.size()));
    }
    std::size_t from = 0;
    for (std::size_t i = 0; i < some.ends.size(); ++i) {
      const double end = some.ends[i];
      if (!(end >= static_cast<double>(from) && end <= static_cast<double>(some.corners.size())) || end != std::floor(end)) {
        throw FileError(fmt::format("{}, cell {}: it does not end behind its beginning, within the file; the file is damaged", file, i));
      }
      const auto to = static_cast<std::size_t>(end);
      append_cell(mesh, some.types[i], corners_of(some, from, to, first, count, file), file);
      from = to;
    }
  }
}

}  // namespace homolog
