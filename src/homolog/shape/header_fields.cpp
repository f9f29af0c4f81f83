// SPDX-License-Identifier: MIT
#include "homolog/shape/header_fields.h"

#include <fmt/format.h>

#include <algorithm>

namespace homolog {
namespace {

template <class Number>
std::vector<Number> numbers(const Text& at, const HeaderField& field, std::size_t count, std::string_view blanks,
                            Number (*take)(Text&, std::string_view&, const char*)) {
  Text text{at.file, {}, field.line};
  std::string blanked(field.text);
  std::replace_if(
      blanked.begin(), blanked.end(), [&](char c) { return blanks.find(c) != std::string_view::npos; }, ' ');
  std::string_view rest = blanked;
  std::vector<Number> taken;
  while (taken.size() < count) taken.push_back(take(text, rest, "a number of this field"));
  if (const std::string_view more = take_word(rest); !more.empty()) {
    fail(text, fmt::format("'{}' stands behind the {} of this field; the file is damaged", shown(more),
                           count == 1 ? "number" : fmt::format("{} numbers", count)));
  }
  return taken;
}

}  // namespace

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

std::vector<double> real_numbers(const Text& at, const HeaderField& field, std::size_t count, std::string_view blanks) {
  return numbers<double>(at, field, count, blanks, take_number);
}

std::vector<long long> whole_numbers(const Text& at, const HeaderField& field, std::size_t count, std::string_view blanks) {
  return numbers<long long>(at, field, count, blanks, take_integer);
}

long long whole_number(const Text& at, const HeaderField& field) { return whole_numbers(at, field, 1)[0]; }

}  // namespace homolog
