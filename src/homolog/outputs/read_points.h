// SPDX-License-Identifier: MIT
// Named points from files: the twin of landmarks.h.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "homolog/outputs/markups.h"

namespace homolog {

inline constexpr const char* readable_points = ".csv, .mrk.json, .fcsv, .tps, .pts (Landmark Editor) and .txt (Morphologika)";

/// Points of a .csv file (a header with the columns x, y, z and perhaps label or name, in any order; others are left out; empty cells or
/// NA: missing), of a .mrk.json or .json one (markups.h), or of an .fcsv, .tps, .pts or .txt (read_fcsv.h, tps.h, landmark_editor.h,
/// morphologika.h). Labels are kept, order too. `specimen`: which one of a .tps or .txt (specimen.h). `ras`: points of .mrk.json and .fcsv,
/// which state their coordinate system, are taken to RAS instead of LPS. Text that is not UTF-8 is taken for Latin-1. Throws FileError,
/// naming the line.
std::vector<MarkupPoint> read_points(const std::filesystem::path& path, const std::string& specimen = "", bool ras = false);

/// Points of CSV text.
std::vector<MarkupPoint> read_points_csv(const std::string& text, const std::string& file);

}  // namespace homolog
