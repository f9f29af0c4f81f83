// SPDX-License-Identifier: MIT
#include "homolog/outputs/landmark_editor.h"

#include <fmt/format.h>

#include "homolog/outputs/landmark_position.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t") == line.npos; }

std::string name_of(const std::string& label, std::size_t number) {
  if (is_blank(label)) return fmt::format("S{:03}", number);
  std::string name = label;
  for (char& c : name) {
    if (static_cast<unsigned char>(c) <= ' ' || c == '"' || c == '\'' || c == '#') c = '_';
  }
  return name;
}

}  // namespace

std::vector<MarkupPoint> read_pts(const std::string& content, const std::string& file) {
  Text text{file, content, 0};
  std::string_view line;
  if (!next_line(text, line) || take_word(line) != "Version")
    fail(text, "the first line must be 'Version 1.0'; this is no .pts of Landmark");
  if (!next_line(text, line)) fail(text, "the number of points is missing; the file is truncated");
  const long long count = take_integer(text, line, "the number of points");
  if (count < 0) fail(text, "the number of points is negative; export the file again");
  std::vector<MarkupPoint> points;
  while (next_line(text, line)) {
    if (is_blank(line)) continue;
    if (static_cast<long long>(points.size()) == count) fail(text, fmt::format("more points follow than the {} announced", count));
    const std::string name(take_word(line));
    points.push_back({name, "", landmark_line(text, line, true)});
  }
  if (static_cast<long long>(points.size()) < count) {
    fail(text, fmt::format("the file ends after {} of {} points; it is truncated", points.size(), count));
  }
  return points;
}

std::string pts_text(const std::vector<MarkupPoint>& points) {
  std::string text = fmt::format("Version 1.0\n{}\n", points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 x = points[i].position.value_or(Vec3::Constant(missing_coordinate));
    text += fmt::format("{} {} {} {}\n", name_of(points[i].label, i), x.x(), x.y(), x.z());
  }
  return text;
}

}  // namespace homolog
