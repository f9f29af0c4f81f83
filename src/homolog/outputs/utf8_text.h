// SPDX-License-Identifier: MIT
// Text files of people: spreadsheets of half of Europe save them in Latin-1.
#pragma once

#include <string>

namespace homolog {

/// The text as UTF-8: itself if it is, else what it says in Latin-1, of which every byte is a character.
std::string utf8_text(std::string text);

}  // namespace homolog
