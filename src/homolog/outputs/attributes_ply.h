// SPDX-License-Identifier: MIT
// A mesh with carried attributes as PLY, and its pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "homolog/match/carry_attributes.h"
#include "homolog/outputs/write_file.h"

namespace homolog {

/// `out` with colours (alpha if any is not 1), values as double, labels as int (as double if they do not fit), and `carried`, 1 for
/// vertices with a place and 0 for the others, where values are nan and labels the no_label of their field. UVs stand at the vertices (s,
/// t) if each has one and there is one picture at most, else at the faces as MeshLab has them (texcoord, texnumber: -1 and no UVs but 0
/// where there are none). Beside it the pictures (pictures.h), which comments "TextureFile NAME" name. `from` names where they are from.
std::vector<OutputFile> attributes_ply(const AttributedMesh& mesh, const std::vector<DensePlace>& places, const std::filesystem::path& out,
                                       const std::string& from);

/// Whether materials say more than a PLY can: anything but their pictures.
bool ply_leaves_out(const Texturing& texturing);

}  // namespace homolog
