// SPDX-License-Identifier: MIT
// Formats of morphometrics hold the landmarks of whole collections: the same ones, in the same order, for every specimen.
#pragma once

#include <string>
#include <vector>

#include "homolog/outputs/markups.h"

namespace homolog {

struct Specimen {
  std::string name;  ///< may be empty
  std::vector<MarkupPoint> points;
};

/// The specimen called `which`, or the one of that number from 1; without `which` the only one. `file` names it in errors. Throws FileError
/// when there is none such, and when there are several to choose from.
const Specimen& chosen_specimen(const std::vector<Specimen>& specimens, const std::string& which, const std::string& file);

/// A name as it may stand in a line of text: one line, without blanks at its ends.
std::string one_line(const std::string& name);

}  // namespace homolog
