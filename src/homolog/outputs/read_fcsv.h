// SPDX-License-Identifier: MIT
// .fcsv, the markups of 3D Slicer before .mrk.json.
#pragma once

#include <string>
#include <vector>

#include "homolog/outputs/markups.h"

namespace homolog {

/// The points of an .fcsv in LPS: the signs of x and y of a file whose CoordinateSystem is RAS or 0 are turned, LPS or 1 stays. A file that
/// states neither is refused. A point whose position status (Slicer 5 writes it after the last named column) is not 2, defined, is missing.
/// `file` names it in errors. Throws FileError, naming the line.
std::vector<MarkupPoint> read_fcsv(const std::string& text, const std::string& file);

}  // namespace homolog
