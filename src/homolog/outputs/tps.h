// SPDX-License-Identifier: MIT
// TPS files of morphometrics (F. J. Rohlf's programs; geomorph and Morpho in R).
#pragma once

#include <string>
#include <vector>

#include "homolog/outputs/specimen.h"

namespace homolog {

/// The specimens of a TPS file: LM3=, or LM= if three coordinates follow; their name is ID=, else IMAGE=. NA is missing, negative numbers
/// are coordinates. Landmarks are labelled 1, 2, ..., the points of CURVES= that follow them C1.1, C1.2, ..., unless a later COMMENT= names
/// them (specimen.h). Coordinates are multiplied by SCALE=. Everything else is left out. `file` names it in errors. Throws FileError,
/// naming the line.
std::vector<Specimen> read_tps(const std::string& text, const std::string& file);

/// One specimen with LM3= and ID=; a missing landmark is "NA NA NA", as geomorph reads it. The format has no place for labels, so they
/// stand in COMMENT= lines, which other programs leave out.
std::string tps_text(const Specimen& specimen);

}  // namespace homolog
