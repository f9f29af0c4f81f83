// SPDX-License-Identifier: MIT
// The folder that a family of matches is told in: program and Python write the same one.
#pragma once

#include <optional>
#include <vector>

#include "homolog/homolog.h"
#include "homolog/match/coverage.h"
#include "homolog/match/symmetry.h"
#include "homolog/outputs/write_folder.h"

namespace homolog {

/// A family with all that is told of it.
struct ToldFamily {
  MeshedShape model, data;
  const Family& family;
  const Params& params;
  const std::vector<MatchParts>& parts;             ///< covered_parts(), one for each match
  std::optional<std::vector<Symmetry>> symmetries;  ///< symmetries_of(), of a shape against itself
};

/// match.json, parts.json, report.html, both meshes with the part that the best match covers, its landmarks, and symmetry.json of a shape
/// against itself. What grows with the meshes is made while it is written, so `told` must live until then.
NamedFiles family_files(const ToldFamily& told);

}  // namespace homolog
