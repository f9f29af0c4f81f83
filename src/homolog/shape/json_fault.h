// SPDX-License-Identifier: MIT
// What nlohmann's JSON library objects to, in our words: its own name its functions and types.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace homolog {

/// Printable and short, to stand in brackets or before a semicolon. `text`: what was read.
std::string json_fault(const nlohmann::json::exception& error, std::string_view text);

}  // namespace homolog
