// SPDX-License-Identifier: MIT
// Formats of morphometrics hold the landmarks of whole collections: the same ones, in the same order, for every specimen.
#pragma once

#include <string>
#include <string_view>
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

/// What a comment says of a landmark, in formats that have no place for names: "landmark 2: left ear"; nothing of one that has none, or
/// no other than its number. Numbers count from 1.
std::string name_comment(const MarkupPoint& point, std::size_t number);

/// Names the landmark of which a comment says so; any other comment says nothing.
void take_name(std::string_view comment, std::vector<MarkupPoint>& points);

/// A name as it may stand in a line of text: one line, without blanks at its ends.
std::string one_line(const std::string& name);

}  // namespace homolog
