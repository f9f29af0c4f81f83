// SPDX-License-Identifier: MIT
// `report.html`: one self-contained page that works offline (viewer/ bundled with three.js). Input is data, never markup.
#pragma once

#include <string>

#include "homolog/homolog.h"
#include "homolog/match/coverage.h"
#include "homolog/match/symmetry.h"

namespace homolog {

/// `parts` as covered_parts() made them, one for each match; `symmetries`, of a shape against itself, as symmetries_of() did.
std::string match_report(const MeshedShape& model, const MeshedShape& data, const Family& family, const std::vector<MatchParts>& parts,
                         const Params& params, const std::vector<Symmetry>& symmetries = {});
std::string points_report(const MeshedShape& shape, const Params& params);

}  // namespace homolog
