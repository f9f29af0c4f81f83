// SPDX-License-Identifier: MIT
// Three words of a landmark file: a position, or a missing landmark.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "homolog/shape/text.h"

namespace homolog {

/// The coordinate by which Landmark Editor and Morphologika mark a missing landmark.
inline constexpr double missing_coordinate = 9999;

/// The position that three words tell; none when each of them is empty, NA, NaN or, if `nines`, 9999. Throws FileError, naming the line,
/// for what is no finite number, and when only some are missing.
std::optional<Vec3> landmark_position(Text& text, const std::array<std::string_view, 3>& words, bool nines = false);

/// The same for the cells of a CSV row.
std::optional<Vec3> landmark_cells(Text& text, const std::array<std::string_view, 3>& cells);

/// The same for a line of exactly three words.
std::optional<Vec3> landmark_line(Text& text, std::string_view line, bool nines = false);

}  // namespace homolog
