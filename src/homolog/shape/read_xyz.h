// SPDX-License-Identifier: MIT
// Point clouds as plain text, a point a line. Strictly: six columns may as well be a place and a colour, and must not pass for normals.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/point_cloud.h"

namespace homolog {

/// Whether the first line that is neither empty, nor a # or // comment, nor a count of points holds three numbers or more and nothing else.
bool is_xyz(std::string_view content);

/// The points in the text of an XYZ file: lines of x y z nx ny nz between blanks, # and // comments, before them the number of points or
/// not, normals of unit length; points with a zero normal are left out. `file` is its name for messages. Throws FileError (no normals,
/// malformed, non-finite numbers).
PointCloud read_xyz(std::string_view content, const std::string& file);

}  // namespace homolog
