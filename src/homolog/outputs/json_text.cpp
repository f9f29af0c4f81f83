// SPDX-License-Identifier: MIT
#include "homolog/outputs/json_text.h"

#include <algorithm>

namespace homolog {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kLineLength = 160;

std::string one_line(const ordered_json& value) {
  // File names may hold bytes that are not UTF-8; the text must still be.
  return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

/// A long list of plain values, as many on a line as fit.
void append_filled(std::string& text, const ordered_json& list, const std::string& margin) {
  text += '[';
  std::size_t column = kLineLength;  // the first value begins a line
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string item = one_line(list[i]) + (i + 1 < list.size() ? "," : "");
    if (column + item.size() > kLineLength) {
      text.append("\n").append(margin);
      column = margin.size();
    }
    text += item;
    column += item.size();
  }
  text.append("\n").append(margin, 1).append("]");
}

void append(std::string& text, const ordered_json& value, std::size_t indent) {
  const std::string line = one_line(value);
  if (!value.is_structured() || indent + line.size() <= kLineLength) {
    text += line;
    return;
  }
  const std::string margin(indent + 1, ' ');
  if (value.is_array() && std::none_of(value.begin(), value.end(), [](const auto& item) { return item.is_structured(); })) {
    append_filled(text, value, margin);
    return;
  }
  text += value.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& [key, item] : value.items()) {
    text.append(first ? "\n" : ",\n").append(margin);
    if (value.is_object()) text.append(one_line(key)).append(": ");
    append(text, item, indent + 1);
    first = false;
  }
  text.append("\n").append(indent, ' ');
  text += value.is_object() ? '}' : ']';
}

}  // namespace

std::string json_text(const ordered_json& value) {
  std::string text;
  append(text, value, 0);
  return text + "\n";
}

}  // namespace homolog
