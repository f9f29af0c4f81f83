// SPDX-License-Identifier: MIT
#include "homolog/outputs/morphologika.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "homolog/outputs/landmark_position.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

constexpr long long most = 1'000'000'000;

struct Line {
  std::size_t number;
  std::string_view text;
};

/// The lines of each section, without blank ones.
struct Sections {
  std::map<std::string, std::vector<Line>> lines;
  std::vector<std::string_view> comments;  ///< without the double quotes about them

  /// The lines of a section; none if it is not there.
  const std::vector<Line>* find(const char* name) const {
    const auto found = lines.find(name);
    return found == lines.end() ? nullptr : &found->second;
  }
};

std::string_view comment_of(std::string_view line) {
  line.remove_prefix(1);
  const std::size_t end = line.find_last_not_of(" \t\r");
  return end != line.npos && line[end] == '"' ? line.substr(0, end) : line;
}

Sections read_sections(Text& text) {
  Sections sections;
  std::vector<Line>* section = nullptr;
  std::string_view line;
  while (next_line(text, line)) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == line.npos) continue;
    line.remove_prefix(begin);
    if (line[0] == '"') {
      sections.comments.push_back(comment_of(line));
    } else if (line[0] == '[') {
      const std::string name = lower(line.substr(1, line.find(']') - 1));
      if (sections.lines.count(name) > 0) fail(text, fmt::format("the section [{}] stands twice", shown(name)));
      section = &sections.lines[name];
    } else if (section == nullptr) {
      fail(text, "a section such as [individuals] must come first; this is no Morphologika file");
    } else {
      section->push_back({text.line, line});
    }
  }
  return sections;
}

long long number_in(Text& text, const Sections& sections, const char* name) {
  const std::vector<Line>* section = sections.find(name);
  if (section == nullptr || section->empty()) fail(text, fmt::format("the section [{}] is missing or empty", name));
  const auto& [line_number, line] = section->front();
  text.line = line_number;
  std::string_view rest = line;
  const long long number = take_integer(text, rest, "the number in a section");
  if (number < 0 || number > most) fail(text, fmt::format("{} cannot be the number of [{}]", number, name));
  return number;
}

/// The rows of [rawpoints]; lines that begin with ' only name the individual that follows.
std::vector<Line> point_rows(Text& text, const Sections& sections, long long individuals, long long landmarks) {
  const std::vector<Line>* section = sections.find("rawpoints");
  if (section == nullptr) fail(text, "the section [rawpoints] is missing");
  std::vector<Line> rows;
  for (const Line& line : *section) {
    text.line = line.number;
    if (line.text[0] != '\'') rows.push_back(line);
  }
  if (static_cast<long long>(rows.size()) != individuals * landmarks) {
    fail(text, fmt::format("[rawpoints] holds {} rows, but {} individuals with {} landmarks need {}", rows.size(), individuals, landmarks,
                           individuals * landmarks));
  }
  return rows;
}

/// A name as it may stand on a line of its own, where what begins with [ or " is a section or a comment.
std::string written_name(const std::string& name) {
  const std::string line = one_line(name);
  return line.substr(std::min(line.find_first_not_of("[\" \t"), line.size()));
}

}  // namespace

std::vector<Specimen> read_morphologika(const std::string& content, const std::string& file) {
  Text text{file, content, 0};
  const Sections sections = read_sections(text);
  const long long individuals = number_in(text, sections, "individuals"), landmarks = number_in(text, sections, "landmarks");
  const long long dimensions = number_in(text, sections, "dimensions");
  if (dimensions != 3) fail(text, fmt::format("landmarks with {} coordinates lie on no surface; 3 are needed", dimensions));
  const std::vector<Line> rows = point_rows(text, sections, individuals, landmarks);
  const std::vector<Line>* names = sections.find("names");
  std::vector<Specimen> specimens;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t individual = i / landmarks, landmark = i % landmarks;
    if (landmark == 0) {
      const bool named = names != nullptr && individual < names->size();
      specimens.push_back({named ? one_line(std::string((*names)[individual].text)) : "", {}});
    }
    text.line = rows[i].number;
    specimens.back().points.push_back({fmt::format("{}", landmark + 1), "", landmark_line(text, rows[i].text, true)});
  }
  for (Specimen& specimen : specimens) {
    for (const std::string_view comment : sections.comments) take_name(comment, specimen.points);
  }
  return specimens;
}

std::string morphologika_text(const Specimen& specimen) {
  const std::string name = written_name(specimen.name);
  std::string text;
  for (std::size_t i = 0; i < specimen.points.size(); ++i) {
    if (const std::string told = name_comment(specimen.points[i], i + 1); !told.empty()) text += fmt::format("\"{}\"\n", told);
  }
  text += fmt::format("[individuals]\n1\n[landmarks]\n{}\n[dimensions]\n3\n[names]\n{}\n[rawpoints]\n'{}\n", specimen.points.size(), name,
                      name);
  for (const MarkupPoint& point : specimen.points) {
    const auto& x = point.position;
    text += x ? fmt::format("{} {} {}\n", x->x(), x->y(), x->z()) : "NA NA NA\n";
  }
  return text;
}

}  // namespace homolog
