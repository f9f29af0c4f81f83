// SPDX-License-Identifier: MIT
// Comma-separated values, RFC 4180: how a line falls into cells, and how a cell is written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "homolog/shape/text.h"

namespace homolog {

/// The cells of a row, whose first line was taken off the text, without the blanks around them; a quoted cell may hold commas, quotes
/// written twice, and line breaks: further lines are taken off, then. Throws FileError, naming the first line, when a quotation mark is not
/// closed.
std::vector<std::string> csv_cells(Text& text, std::string_view line, char separator = ',');

/// A cell as readers take it for one: quoted if it holds what would end it; control characters but line breaks become blanks.
std::string csv_cell(std::string text);

}  // namespace homolog
