// SPDX-License-Identifier: MIT
#include "homolog/shape/json_fault.h"

#include <fmt/format.h>

#include <algorithm>

#include "homolog/shape/text.h"

namespace homolog {
namespace {

constexpr std::size_t longest = 20;  // of what is shown of the file

/// Where the text stops to be JSON: the line, and what stands there.
std::string place(std::string_view text, std::size_t bytes) {
  const std::string_view before = text.substr(0, std::min(bytes, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end() - (before.ends_with('\n') ? 1 : 0), '\n');
  const std::string_view last = before.substr(before.size() - std::min(longest, before.size()));
  return fmt::format("it stops being JSON in line {}, at '{}'", line, shown(last));
}

}  // namespace

std::string json_fault(const nlohmann::json::exception& error, std::string_view text) {
  constexpr int too_large = 406, not_found = 403, out_of_range = 401;  // the library's documented numbers
  if (const auto* parsing = dynamic_cast<const nlohmann::json::parse_error*>(&error)) return place(text, parsing->byte);
  if (error.id == too_large) return "a number in it is too large";
  if (error.id == out_of_range) return "a list in it is too short";
  const std::string reason = error.what();
  if (error.id == not_found) return shown(reason.substr(reason.find("] ") + 2), 100);  // "key 'x' not found"
  const std::string type = reason.substr(reason.rfind(' ') + 1);                       // "cannot use at() with array", "..., but is array"
  return fmt::format("a value in it is of the type {}, which does not belong there", shown(type));
}

}  // namespace homolog
