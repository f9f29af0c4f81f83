// SPDX-License-Identifier: MIT
// Morphologika files (O'Higgins & Jones), as geomorph and Stratovan Checkpoint use them, too.
#pragma once

#include <string>
#include <vector>

#include "homolog/outputs/specimen.h"

namespace homolog {

/// The individuals of a Morphologika file: [individuals], [landmarks], [dimensions], [names] and [rawpoints]; 9999 or NA is missing.
/// Landmarks are labelled 1, 2, ..., unless a comment (a line that begins with a double quote) names them (specimen.h). Other sections are
/// left out. `file` names it in errors. Throws FileError, naming the line.
std::vector<Specimen> read_morphologika(const std::string& text, const std::string& file);

/// One individual; a missing landmark is "NA NA NA", as geomorph reads it. The format has no place for labels, so they
/// stand in comments before the first section, where other programs look for nothing.
std::string morphologika_text(const Specimen& specimen);

}  // namespace homolog
