// SPDX-License-Identifier: MIT
// The pictures that a mesh with carried attributes lies on, as files beside its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "homolog/outputs/write_file.h"
#include "homolog/shape/texturing.h"

namespace homolog {

/// "STEM.NAME", STEM of `out`.
std::string picture_name(const std::filesystem::path& out, const Image& image);

/// Every picture that a material has, bytes unchanged.
std::vector<OutputFile> picture_files(const Texturing& texturing, const std::filesystem::path& out);

}  // namespace homolog
