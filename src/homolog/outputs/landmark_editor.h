// SPDX-License-Identifier: MIT
// .pts files of Landmark Editor (IDAV); Morpho in R reads and writes them, too.
#pragma once

#include <string>
#include <vector>

#include "homolog/outputs/markups.h"

namespace homolog {

/// "Version 1.0", the number of points, and a line "NAME x y z" for each, single points (S000) and those of curves (C000) alike; three
/// times 9999 is missing. `file` names it in errors. Throws FileError, naming the line.
std::vector<MarkupPoint> read_pts(const std::string& text, const std::string& file);

/// The same. A name is one word that R takes for one, so '_' stands for blanks, quotes and '#'; a point without a label is S000, ...
std::string pts_text(const std::vector<MarkupPoint>& points);

}  // namespace homolog
