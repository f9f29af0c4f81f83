// SPDX-License-Identifier: MIT
#include "homolog/outputs/specimen.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "homolog/base/errors.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

constexpr std::size_t most_told = 6;

std::string names_of(const std::vector<Specimen>& specimens) {
  std::string names;
  for (std::size_t i = 0; i < specimens.size() && i < most_told; ++i) {
    names += fmt::format("{}{} {}", i == 0 ? "" : ", ", i + 1, specimens[i].name.empty() ? "(no name)" : shown(specimens[i].name));
  }
  return specimens.size() > most_told ? names + ", ..." : names;
}

}  // namespace

const Specimen& chosen_specimen(const std::vector<Specimen>& specimens, const std::string& which, const std::string& file) {
  if (specimens.empty()) throw FileError(fmt::format("{}: it holds no landmarks; export them again", file));
  if (which.empty()) {
    if (specimens.size() == 1) return specimens[0];
    throw FileError(
        fmt::format("{}: it holds {} specimens; say which one is meant by its name or number (--specimen; in Python specimen=): {}", file,
                    specimens.size(), names_of(specimens)));
  }
  const auto is_meant = [&](const Specimen& specimen) { return specimen.name == which; };
  const auto first = std::find_if(specimens.begin(), specimens.end(), is_meant);
  if (const auto bearing = std::count_if(first, specimens.end(), is_meant); bearing > 1) {
    throw FileError(fmt::format("{}: {} specimens have the name '{}'; say which one is meant by its number: {}", file, bearing,
                                shown(which), names_of(specimens)));
  }
  if (first != specimens.end()) return *first;
  for (std::size_t i = 0; i < specimens.size(); ++i) {
    if (fmt::format("{}", i + 1) == which) return specimens[i];
  }
  throw FileError(fmt::format("{}: it holds no specimen '{}', but {}", file, shown(which), names_of(specimens)));
}

std::string name_comment(const MarkupPoint& point, std::size_t number) {
  const std::string name = one_line(point.label);
  return name.empty() || name == fmt::format("{}", number) ? "" : fmt::format("landmark {}: {}", number, name);
}

void take_name(std::string_view comment, std::vector<MarkupPoint>& points) {
  if (take_word(comment) != "landmark") return;
  std::size_t number = 0;
  const std::string_view word = take_word(comment);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool is_number = error == std::errc() && std::string_view(end, word.data() + word.size() - end) == ":";
  const std::string name = one_line(std::string(comment));
  if (is_number && number >= 1 && number <= points.size() && !name.empty()) points[number - 1].label = name;
}

std::string one_line(const std::string& name) {
  std::string line = name;
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  line.erase(0, line.find_first_not_of(' '));
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

}  // namespace homolog
