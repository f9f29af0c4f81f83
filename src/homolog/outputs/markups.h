// SPDX-License-Identifier: MIT
// 3D Slicer's markups (.mrk.json, schema 1.0.3): point lists, written and read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "homolog/base/vec.h"

namespace homolog {

struct MarkupPoint {
  std::string label, description;
  std::optional<Vec3> position;  ///< none: missing (positionStatus "undefined", without coordinates)
};

/// One list of points. Coordinates are taken as they are; "coordinateSystem" states RAS if they are `ras` (Mesh::ras), else LPS, Slicer's
/// own default.
std::string markups_text(const std::vector<MarkupPoint>& points, bool ras = false);

/// The control points of all markups in the file, in LPS: the signs of x and y of a file that states RAS are turned; one that states
/// nothing is LPS, as Slicer's schema says. Whatever is not "defined" is missing. `file` names it in errors. Throws FileError.
std::vector<MarkupPoint> read_markups(const std::string& text, const std::string& file);

}  // namespace homolog
