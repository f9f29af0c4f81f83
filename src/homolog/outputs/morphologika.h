// SPDX-License-Identifier: MIT
// Morphologika files (O'Higgins & Jones), as geomorph and Stratovan Checkpoint use them, too.
#pragma once

#include <string>
#include <vector>

#include "homolog/outputs/specimen.h"

namespace homolog {

/// The individuals of a Morphologika file: [individuals], [landmarks], [dimensions], [names] and [rawpoints]; 9999 or NA is missing.
/// Landmarks have no names there, so they are labelled 1, 2, ... Other sections are left out. `file` names it in errors. Throws FileError,
/// naming the line.
std::vector<Specimen> read_morphologika(const std::string& text, const std::string& file);

/// One individual; a missing landmark is "NA NA NA", as geomorph reads it. The format keeps the order, not the labels.
std::string morphologika_text(const Specimen& specimen);

}  // namespace homolog
