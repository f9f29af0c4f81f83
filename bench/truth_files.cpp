// SPDX-License-Identifier: MIT
#include "truth_files.h"

#include <fmt/format.h>

#include <map>
#include <numeric>
#include <sstream>

#include "text_lines.h"

namespace homolog::bench {
namespace {

// A map needs as many.
constexpr std::size_t least_points = 4;

FileError malformed(const TextLines& lines) { return fault_at(lines, fmt::format("cannot understand '{}'", lines.line)); }

void check_vertex(const TextLines& lines, int vertex, std::size_t count) {
  if (vertex >= 0 && static_cast<std::size_t>(vertex) < count) return;
  throw fault_at(lines, fmt::format("there is no vertex {} among {}, counted from 0", vertex, count));
}

// "L" of "foot_L" and the like, with its opposite.
const std::vector<std::pair<std::string, std::string>> opposite_endings = {{"_L", "_R"}, {".L", ".R"}, {"_pos_z", "_neg_z"}};

std::string opposite_name(const std::string& name) {
  for (const auto& [left, right] : opposite_endings) {
    if (name.ends_with(left)) return name.substr(0, name.size() - left.size()) + right;
    if (name.ends_with(right)) return name.substr(0, name.size() - right.size()) + left;
  }
  return name;
}

std::vector<std::size_t> swap_by_names(const std::vector<Landmark>& landmarks) {
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < landmarks.size(); ++i) places[landmarks[i].name] = i;
  std::vector<std::size_t> swap(landmarks.size());
  bool any = false;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const auto found = places.find(opposite_name(landmarks[i].name));
    swap[i] = found == places.end() ? i : found->second;
    any |= swap[i] != i;
  }
  return any ? swap : std::vector<std::size_t>{};
}

}  // namespace

std::vector<IdentityGroup> read_identity_groups(const std::filesystem::path& set) {
  std::vector<IdentityGroup> groups;
  TextLines lines{.file = set / "IDENTITY.corr.txt"};
  while (next_line(lines)) {
    // "# ... for every pair of: a b c  (843 vertices each)"
    const std::string& line = lines.line;
    if (line.empty()) continue;
    const auto colon = line.find(':'), bracket = line.rfind('(');
    if (colon == std::string::npos || bracket == std::string::npos || bracket < colon) {
      if (line[0] == '#') continue;  // a remark
      throw malformed(lines);
    }
    IdentityGroup group;
    group.line = lines.number;
    std::istringstream names(line.substr(colon + 1, bracket - colon - 1));
    for (std::string name; names >> name;) group.names.push_back(name);
    if (!(std::istringstream(line.substr(bracket + 1)) >> group.vertices) || group.names.empty()) throw malformed(lines);
    if (group.vertices < least_points) throw fault_at(lines, "fewer than four vertices do not tell a map");
    groups.push_back(std::move(group));
  }
  return groups;
}

std::vector<std::pair<int, int>> read_vertex_pairs(const std::filesystem::path& file, std::size_t a_count, std::size_t b_count) {
  std::vector<std::pair<int, int>> pairs;
  TextLines lines{.file = file};
  if (!lines.in) throw FileError(fmt::format("{}: cannot be read", file.string()));
  while (next_entry(lines)) {
    std::pair<int, int> pair;
    if (!(std::istringstream(lines.line) >> pair.first >> pair.second)) throw malformed(lines);
    check_vertex(lines, pair.first, a_count);
    check_vertex(lines, pair.second, b_count);
    pairs.push_back(pair);
  }
  if (pairs.size() < least_points) throw fault_at(lines, fmt::format("the file ends after {} pairs, and four are needed", pairs.size()));
  return pairs;
}

std::vector<Landmark> read_landmarks(const std::filesystem::path& file) {
  std::vector<Landmark> landmarks;
  TextLines lines{.file = file};
  if (!lines.in) return landmarks;
  while (next_entry(lines)) {
    Landmark landmark;
    Vec3& p = landmark.position;
    if (!(std::istringstream(lines.line) >> landmark.name >> p.x() >> p.y() >> p.z())) throw malformed(lines);
    landmarks.push_back(std::move(landmark));
  }
  if (landmarks.size() < least_points) {
    throw fault_at(lines, fmt::format("the file ends after {} landmarks, and four are needed", landmarks.size()));
  }
  return landmarks;
}

std::vector<std::size_t> read_swap(const std::filesystem::path& file, const std::vector<Landmark>& landmarks) {
  TextLines lines{.file = file};
  if (!lines.in) return swap_by_names(landmarks);
  std::vector<std::size_t> swap(landmarks.size());
  std::iota(swap.begin(), swap.end(), std::size_t{0});
  while (next_entry(lines)) {
    std::istringstream numbers(lines.line);
    std::size_t a = 0, b = 0;
    if (!(numbers >> a) || a >= landmarks.size()) throw malformed(lines);
    if (!(numbers >> b)) continue;
    if (b >= landmarks.size()) throw malformed(lines);
    swap[a] = b;
    swap[b] = a;
  }
  return swap;
}

}  // namespace homolog::bench
