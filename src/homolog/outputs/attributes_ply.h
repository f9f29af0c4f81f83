// SPDX-License-Identifier: MIT
// A mesh with carried attributes as PLY.
#pragma once

#include <string>

#include "homolog/match/carry_attributes.h"

namespace homolog {

/// The mesh, without its texturing, with its colours (alpha if any is not 1), values as double, labels as int (as double if they do not
/// fit), and `carried`, 1 for vertices with a place and 0 for the others, where values are nan and labels the no_label of their field.
/// `from` names where they are from.
std::string attributes_ply(const AttributedMesh& mesh, const std::vector<DensePlace>& places, const std::string& from);

}  // namespace homolog
