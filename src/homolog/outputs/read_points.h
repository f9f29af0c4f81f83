// SPDX-License-Identifier: MIT
// Named points from files: the twin of landmarks.h.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "homolog/outputs/markups.h"

namespace homolog {

/// Points of a .csv file (a header with the columns x, y, z and perhaps label, in any order; others are left out; empty cells or NA:
/// missing) or of a .mrk.json or .json one (markups.h). Labels are kept, order too. Throws FileError, naming the line.
std::vector<MarkupPoint> read_points(const std::filesystem::path& path);

/// The same for CSV text.
std::vector<MarkupPoint> read_points_csv(const std::string& text, const std::string& file);

}  // namespace homolog
