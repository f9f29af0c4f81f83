// SPDX-License-Identifier: MIT
// JSON as text that a person can read as well: whatever fits stands on one line. Numbers are written shortest, so that reading gives
// the same number back; keys keep their order.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "homolog/base/errors.h"
#include "homolog/shape/json_fault.h"
#include "homolog/shape/text.h"

namespace homolog {

/// Of the files that begin with json_head().
inline constexpr int format_version = 1;

/// What such a file begins with: its format, the version of that, and the program.
nlohmann::ordered_json json_head(const char* format);

/// Throws FileError, which names the file, unless it begins so. Keys that are missing: nlohmann's exception, for read_json() to turn.
void check_head(const nlohmann::ordered_json& json, const char* format, const std::string& file);

/// A value for a message. Only a plain one is written out: lists may lie in lists deeper than the stack of what writes them.
std::string shown_value(const nlohmann::ordered_json& value);

/// As the library writes it, on one line or with so many blanks for each level. File names may hold bytes that are not UTF-8; the text must
/// still be.
std::string json_dump(const nlohmann::ordered_json& value, int indent = -1);

std::string json_text(const nlohmann::ordered_json& value);

/// The same as a piece of a larger text, on a line that begins `indent` characters in; without a line's end.
std::string json_piece(const nlohmann::ordered_json& value, std::size_t indent);

/// A list of plain values laid out like this, from the text item(i) of each, so that millions of them need no JSON values.
std::string json_list(std::size_t count, const std::function<std::string(std::size_t)>& item, std::size_t indent);

/// What `read` makes of a file's JSON. Whatever the library objects to becomes a FileError that names the file and what it should be.
template <class Read>
auto read_json(const std::string& text, const std::string& file, const char* kind, const Read& read) {
  try {
    return read(nlohmann::ordered_json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    throw FileError(fmt::format("{}: this is not a file of {} ({}); it is another one or damaged", file, kind, json_fault(error, text)));
  }
}

}  // namespace homolog
