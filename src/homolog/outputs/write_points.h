// SPDX-License-Identifier: MIT
// Named points as files: the twin of read_points.h.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "homolog/outputs/carried.h"
#include "homolog/outputs/markups.h"

namespace homolog {

inline constexpr const char* writable_points = ".csv, .mrk.json, .tps, .pts (Landmark Editor) or .txt (Morphologika)";

/// Whether points are written to a file with this ending.
bool writes_points(const std::filesystem::path& path);

/// What stands in a file with the ending of `path`. `specimen`: its name, for formats that have one; `ras` and `lists`: what a .mrk.json
/// states (markups_text()). A .csv has the columns label, x, y and z, of carried points besides what carried_csv() tells. Throws ParamError
/// for another ending.
std::string points_text(const std::vector<MarkupPoint>& points, const std::filesystem::path& path, const std::string& specimen,
                        bool ras = false, const std::vector<MarkupList>& lists = {});
std::string points_text(const std::vector<CarriedLandmark>& landmarks, const std::filesystem::path& path, const std::string& specimen,
                        bool ras = false, const std::vector<MarkupList>& lists = {});

}  // namespace homolog
