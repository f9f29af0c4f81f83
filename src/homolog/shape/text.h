// SPDX-License-Identifier: MIT
// Reading text formats line by line, with errors that name the file and the line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "homolog/base/vec.h"

namespace homolog {

/// What is still to be read of a file; `line` is the number of the line read last, from 1.
struct Text {
  std::string file;
  std::string_view rest;
  std::size_t line = 0;
};

/// A word of a file as it may stand in a message: short and printable, whatever it holds.
std::string shown(std::string_view word, std::size_t longest = 30);

/// Throws FileError: "FILE, line N: WHAT".
[[noreturn]] void fail(const Text& text, const std::string& what);

/// The next line, without its end; false at the end of the file.
bool next_line(Text& text, std::string_view& line);

/// The next line that holds more than blanks and a # comment, without that comment; false at the end of the file.
bool next_data_line(Text& text, std::string_view& line);

/// Takes the first word off a line; empty when there is none.
std::string_view take_word(std::string_view& line);

/// What is left of a line, without the blanks around it.
std::string rest_of(std::string_view line);

/// ASCII letters made small.
std::string lower(std::string_view text);

/// Takes a finite number off a line. Throws FileError, naming `what`, when there is none.
double take_number(Text& text, std::string_view& line, const char* what);

/// Takes a whole number off a line. Throws FileError, naming `what`, when there is none.
long long take_integer(Text& text, std::string_view& line, const char* what);

/// Takes three finite numbers off a line. Throws FileError when there are fewer.
Vec3 take_position(Text& text, std::string_view& line);

}  // namespace homolog
