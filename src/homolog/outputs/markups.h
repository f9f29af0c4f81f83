// SPDX-License-Identifier: MIT
// 3D Slicer's markups (.mrk.json, schema 1.0.3): point lists, written and read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "homolog/base/vec.h"

namespace homolog {

/// How Slicer shows a point and what it lets one do with it.
struct MarkupDisplay {
  bool selected = true, locked = false, visible = true;
};

struct MarkupPoint {
  std::string label, description;
  std::optional<Vec3> position;  ///< none: missing (positionStatus "undefined", without coordinates)
  MarkupDisplay display = {};
};

/// A markup of a file, beside its points.
struct MarkupList {
  std::size_t points = 0;  ///< how many of the file's
  std::string type = "Fiducial", name = {}, units = {};
  std::string dropped = {};  ///< another type than points alone can make, such as Plane; then `type` is Fiducial
};

/// The markups of a file: the types that points make (Fiducial, Line, Angle, Curve, ClosedCurve), names and coordinateUnits. Throws
/// FileError.
std::vector<MarkupList> read_markup_lists(const std::string& text, const std::string& file);

/// One list of points, or those of `lists`, which have as many points together. Coordinates are taken as they are; "coordinateSystem"
/// states RAS if they are `ras` (Mesh::ras), else LPS, Slicer's own default.
std::string markups_text(const std::vector<MarkupPoint>& points, bool ras = false, const std::vector<MarkupList>& lists = {});

/// The control points of all markups in the file, in LPS: the signs of x and y of a file that states RAS are turned; one that states
/// nothing is LPS, as Slicer's schema says. Whatever is not "defined" is missing. `file` names it in errors. Throws FileError.
std::vector<MarkupPoint> read_markups(const std::string& text, const std::string& file);

}  // namespace homolog
