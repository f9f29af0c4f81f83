// SPDX-License-Identifier: MIT
// The numbers of match.json that lay one shape onto another. What cannot be is a FileError that names the file.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "homolog/match/thin_plate_spline.h"

namespace homolog {

/// Throws FileError: "FILE: WHAT".
[[noreturn]] void fail(const std::string& file, const std::string& what);

/// From 0 on. A number with a point, or one too large, is none.
std::size_t read_whole_number(const nlohmann::ordered_json& value, const std::string& file);

Vec3 read_vector(const nlohmann::ordered_json& item, const std::string& file);
std::vector<Vec3> read_vectors(const nlohmann::ordered_json& list, const std::string& file);
Mat4 read_matrix(const nlohmann::ordered_json& rows);
ThinPlateSpline read_warp(const nlohmann::ordered_json& json, const std::string& file);

}  // namespace homolog
