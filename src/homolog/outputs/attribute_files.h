// SPDX-License-Identifier: MIT
// A mesh with carried attributes in the format that a file's name asks for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "homolog/match/carry_attributes.h"
#include "homolog/outputs/write_file.h"

namespace homolog {

inline constexpr const char* writable_attributes = ".ply, .obj, .glb or .gltf";

/// Whether attributes can be written as that.
bool writes_attributes(const std::filesystem::path& out);

/// attributes_ply(), attributes_obj() or attributes_gltf(), by the name of `out`. `places` of the mesh's vertices; `from` names where they
/// are from, `name` the mesh within a glTF. Throws OutputError for other names.
std::vector<OutputFile> attribute_files(const AttributedMesh& carried, const std::vector<DensePlace>& places,
                                        const std::filesystem::path& out, const std::string& from, const std::string& name = "");

/// What of the giver `out` will not hold, a sentence for each; `from` names the giver.
std::vector<std::string> attribute_losses(const AttributedMesh& giver, const std::filesystem::path& out, const std::string& from);

}  // namespace homolog
