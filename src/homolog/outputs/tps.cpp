// SPDX-License-Identifier: MIT
#include "homolog/outputs/tps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "homolog/outputs/landmark_position.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

bool next_filled_line(Text& text, std::string_view& line) {
  while (next_line(text, line)) {
    if (line.find_first_not_of(" \t") != line.npos) return true;
  }
  return false;
}

/// A line KEY=VALUE; the key in capitals.
struct Entry {
  std::string key;
  std::string_view value;
};

Entry split_entry(Text& text, std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == line.npos) fail(text, "here should be KEY=VALUE; are there more landmarks than LM3= announces?");
  std::string_view before = line.substr(0, equals);
  std::string key(take_word(before));
  std::transform(key.begin(), key.end(), key.begin(), [](unsigned char c) { return std::toupper(c); });
  if (key == "CURVES3" || key == "POINTS3") key.pop_back();  // as some write beside LM3=
  return {key, line.substr(equals + 1)};
}

long long count_of(Text& text, const Entry& entry) {
  std::string_view value = entry.value;
  const long long count = take_integer(text, value, "the number of landmarks");
  if (count < 0) fail(text, "the number of landmarks is negative; export the file again");
  return count;
}

/// `count` lines; label_of(i), from 1, names their landmarks.
template <class LabelOf>
void read_landmarks(Text& text, long long count, const LabelOf& label_of, std::vector<MarkupPoint>& points) {
  for (long long i = 1; i <= count; ++i) {
    std::string_view line;
    if (!next_filled_line(text, line)) fail(text, fmt::format("the file ends after {} of {} landmarks; it is truncated", i - 1, count));
    if (line.find('=') != line.npos)
      fail(text, fmt::format("{} landmarks are announced, but {} are there; export them again", count, i - 1));
    points.push_back({label_of(i), "", landmark_line(text, line)});
  }
}

void skip_lines(Text& text, long long count) {
  std::string_view line;
  for (long long i = 0; i < count && next_filled_line(text, line); ++i) {
  }
}

void scale(Text& text, const Entry& entry, Specimen& specimen) {
  std::string_view value = entry.value;
  const double factor = take_number(text, value, "the scale");
  for (MarkupPoint& point : specimen.points) {
    if (!point.position) continue;
    *point.position *= factor;
    if (!point.position->allFinite()) fail(text, "the scaled coordinates are not finite numbers");
  }
}

struct Reader {
  std::vector<Specimen> specimens;
  bool in_curves = false, has_id = false;
  int curve = 0;

  void read_entry(Text& text, const Entry& entry) {
    if (entry.key == "LM" || entry.key == "LM3") {
      specimens.emplace_back();
      in_curves = has_id = false;
      curve = 0;
      return read_landmarks(
          text, count_of(text, entry), [](long long i) { return fmt::format("{}", i); }, specimens.back().points);
    }
    if (specimens.empty()) fail(text, "a specimen begins with LM3=, but this line comes before");
    Specimen& specimen = specimens.back();
    if (entry.key == "CURVES" || entry.key == "OUTLINES") {
      in_curves = entry.key == "CURVES";
    } else if (entry.key == "POINTS" && in_curves) {
      ++curve;
      read_landmarks(
          text, count_of(text, entry), [this](long long i) { return fmt::format("C{}.{}", curve, i); }, specimen.points);
    } else if (entry.key == "POINTS") {
      skip_lines(text, count_of(text, entry));
    } else if (entry.key == "ID" || (entry.key == "IMAGE" && !has_id)) {
      specimen.name = one_line(std::string(entry.value));
      has_id = entry.key == "ID";
    } else if (entry.key == "COMMENT") {
      take_name(entry.value, specimen.points);
    } else if (entry.key == "SCALE") {
      scale(text, entry, specimen);
    }
  }
};

}  // namespace

std::vector<Specimen> read_tps(const std::string& content, const std::string& file) {
  Text text{file, content, 0};
  Reader reader;
  std::string_view line;
  while (next_filled_line(text, line)) reader.read_entry(text, split_entry(text, line));
  if (reader.specimens.empty()) fail(text, "the file holds no LM3=; it is no TPS file, or empty");
  return reader.specimens;
}

std::string tps_text(const Specimen& specimen) {
  std::string text = fmt::format("LM3={}\n", specimen.points.size());
  for (const MarkupPoint& point : specimen.points) {
    const auto& x = point.position;
    text += x ? fmt::format("{} {} {}\n", x->x(), x->y(), x->z()) : "NA NA NA\n";
  }
  for (std::size_t i = 0; i < specimen.points.size(); ++i) {
    if (const std::string name = name_comment(specimen.points[i], i + 1); !name.empty()) text += fmt::format("COMMENT={}\n", name);
  }
  return text + fmt::format("ID={}\n", one_line(specimen.name));
}

}  // namespace homolog
