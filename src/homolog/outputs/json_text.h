// SPDX-License-Identifier: MIT
// JSON as text that a person can read as well: whatever fits stands on one line. Numbers are written shortest, so that reading gives
// the same number back; keys keep their order.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace homolog {

std::string json_text(const nlohmann::ordered_json& value);

}  // namespace homolog
