// SPDX-License-Identifier: MIT
#include "homolog/shape/header_fields.h"

#include <fmt/format.h>

#include <algorithm>

namespace homolog {

void add_field(const Text& text, HeaderFields& fields, std::string name, std::string_view value) {
  const auto [field, is_new] = fields.emplace(std::move(name), HeaderField{value, text.line});
  if (!is_new) fail(text, fmt::format("the field '{}' stands twice; the file is damaged", shown(field->first)));
}

const HeaderField* find_field(const HeaderFields& fields, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    if (const auto field = fields.find(name); field != fields.end()) return &field->second;
  }
  return nullptr;
}

const HeaderField& needed_field(const Text& text, const HeaderFields& fields, std::string_view name) {
  const HeaderField* field = find_field(fields, {name});
  if (!field) fail(text, fmt::format("the header lacks the field '{}'", name));
  return *field;
}

std::string_view word_of(const HeaderFields& fields, std::initializer_list<std::string_view> names) {
  const HeaderField* field = find_field(fields, names);
  std::string_view rest = field ? field->text : std::string_view();
  return take_word(rest);
}

std::string other_file(const Text& text, const HeaderFields& fields, std::initializer_list<std::string_view> names) {
  const HeaderField* field = find_field(fields, names);
  if (!field) return {};
  const std::string file = rest_of(field->text);
  if (word_of(fields, names) == "LIST" || file.find('%') != std::string::npos) {
    fail({text.file, {}, field->line}, "the voxels stand in several files; save the volume as one");
  }
  return file;
}

FieldNumbers::FieldNumbers(const Text& at, const HeaderField& field, std::string_view blanks)
    : text_{at.file, {}, field.line}, blanked_(field.text) {
  std::replace_if(
      blanked_.begin(), blanked_.end(), [&](char c) { return blanks.find(c) != std::string_view::npos; }, ' ');
  rest_ = blanked_;
}

double FieldNumbers::real() { return take_number(text_, rest_, "a number of this field"); }

long long FieldNumbers::whole() { return take_integer(text_, rest_, "a number of this field"); }

}  // namespace homolog
