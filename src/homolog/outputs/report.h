// SPDX-License-Identifier: MIT
// `report.html`: one self-contained page that works offline (viewer/ bundled with three.js). Input is data, never markup.
#pragma once

#include <string>

#include "homolog/homolog.h"
#include "homolog/match/coverage.h"

namespace homolog {

/// `parts` as covered_parts() made them, one for each match.
std::string match_report(const MeshedShape& model, const MeshedShape& data, const Family& family, const std::vector<MatchParts>& parts,
                         const Params& params);
std::string points_report(const MeshedShape& shape, const Params& params);

}  // namespace homolog
