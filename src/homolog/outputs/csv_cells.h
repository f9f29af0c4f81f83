// SPDX-License-Identifier: MIT
// Comma-separated values, RFC 4180: how a line falls into cells, and how a cell is written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "homolog/shape/text.h"

namespace homolog {

/// The cells of a line without the blanks around them; a quoted cell may hold commas, and quotes written twice. Throws FileError, naming
/// the line, when a quotation mark is not closed.
std::vector<std::string> csv_cells(const Text& text, std::string_view line, char separator = ',');

/// A cell as readers take it for one: quoted if it holds what would end it.
std::string csv_cell(const std::string& text);

}  // namespace homolog
