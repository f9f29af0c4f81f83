// SPDX-License-Identifier: MIT
// Headers of volume files: a name and a value a line.
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "homolog/shape/text.h"

namespace homolog {

/// What stands behind a field's name, and in which line.
struct HeaderField {
  std::string_view text;
  std::size_t line;
};

using HeaderFields = std::map<std::string, HeaderField, std::less<>>;

/// Adds a field that stands in the line read last. Throws FileError for a name that is there already.
void add_field(const Text& text, HeaderFields& fields, std::string name, std::string_view value);

/// The first of these that is there, or nullptr: formats know some fields by several names.
const HeaderField* find_field(const HeaderFields& fields, std::initializer_list<std::string_view> names);

/// Throws FileError when it is not there.
const HeaderField& needed_field(const Text& text, const HeaderFields& fields, std::string_view name);

/// The first word of the first of these that is there, else empty.
std::string_view word_of(const HeaderFields& fields, std::initializer_list<std::string_view> names);

/// The file that holds the voxels by the first of these fields, else empty; its name may have blanks in it. Throws FileError when there are
/// several.
std::string other_file(const Text& text, const HeaderFields& fields, std::initializer_list<std::string_view> names);

/// The numbers of a field. Throws FileError at its line when there are more or fewer than `count`. The characters in `blanks` are taken for
/// blanks.
std::vector<double> real_numbers(const Text& at, const HeaderField& field, std::size_t count, std::string_view blanks = {});
std::vector<long long> whole_numbers(const Text& at, const HeaderField& field, std::size_t count, std::string_view blanks = {});

/// The same for a field of one number.
long long whole_number(const Text& at, const HeaderField& field);

}  // namespace homolog
