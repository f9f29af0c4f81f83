// SPDX-License-Identifier: MIT
#include "homolog/outputs/json_text.h"

#include <algorithm>

namespace homolog {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kLineLength = 160;

void append(std::string& text, const ordered_json& value, std::size_t indent) {
  const std::string line = json_dump(value);
  if (!value.is_structured() || indent + line.size() <= kLineLength) {
    text += line;
    return;
  }
  const std::string margin(indent + 1, ' ');
  if (value.is_array() && std::none_of(value.begin(), value.end(), [](const auto& item) { return item.is_structured(); })) {
    text += json_list(
        value.size(), [&](std::size_t i) { return json_dump(value[i]); }, indent);
    return;
  }
  text += value.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& [key, item] : value.items()) {
    text.append(first ? "\n" : ",\n").append(margin);
    if (value.is_object()) text.append(json_dump(key)).append(": ");
    append(text, item, indent + 1);
    first = false;
  }
  text.append("\n").append(indent, ' ');
  text += value.is_object() ? '}' : ']';
}

}  // namespace

ordered_json json_head(const char* format) {
  return {{"format", format}, {"version", format_version}, {"program", "homolog " HOMOLOG_VERSION}};
}

void check_head(const ordered_json& json, const char* format, const std::string& file) {
  if (json.at("format") != format)
    throw FileError(fmt::format("{}: its format is {}, not \"{}\"; name the right file", file, shown_value(json["format"]), format));
  if (json.at("version") != format_version) {
    throw FileError(fmt::format("{}: its version is {}, but only {} is known; use a newer homolog", file, shown_value(json["version"]),
                                format_version));
  }
}

std::string shown_value(const ordered_json& value) { return shown(value.is_structured() ? value.type_name() : value.dump()); }

std::string json_dump(const ordered_json& value, int indent) {
  return value.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

std::string json_text(const ordered_json& value) { return json_piece(value, 0) + "\n"; }

std::string json_piece(const ordered_json& value, std::size_t indent) {
  std::string text;
  append(text, value, indent);
  return text;
}

std::string json_list(std::size_t count, const std::function<std::string(std::size_t)>& item, std::size_t indent) {
  std::string line = "[";
  for (std::size_t i = 0; i < count && line.size() < kLineLength; ++i) line.append(i > 0 ? "," : "").append(item(i));
  line += ']';
  if (indent + line.size() <= kLineLength) return line;
  const std::string margin(indent + 1, ' ');
  std::string text = "[";
  std::size_t column = kLineLength;          // the first value begins a line
  for (std::size_t i = 0; i < count; ++i) {  // as many on a line as fit
    const std::string value = item(i);
    const std::size_t length = value.size() + (i + 1 < count ? 1 : 0);
    if (column + length > kLineLength) {
      text.append("\n").append(margin);
      column = margin.size();
    }
    text += value;
    if (i + 1 < count) text += ',';
    column += length;
  }
  return text.append("\n").append(margin, 1).append("]");
}

}  // namespace homolog
