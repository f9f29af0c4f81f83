// SPDX-License-Identifier: MIT
#include "truth_files.h"

#include <fmt/format.h>

#include <map>
#include <numeric>
#include <sstream>

#include "homolog/base/read_file.h"
#include "homolog/shape/text.h"

namespace homolog::bench {
namespace {

// A map needs as many.
constexpr std::size_t least_points = 4;

[[noreturn]] void fail_malformed(const Text& text, std::string_view line) { fail(text, fmt::format("cannot understand '{}'", line)); }

[[noreturn]] void fail_at_end(Text text, std::size_t count, const char* what) {
  ++text.line;
  fail(text, fmt::format("the file ends after {} {}, and four are needed", count, what));
}

/// The next line that is neither empty nor a remark; false at the end. A # within a line may belong to a name.
bool next_entry(Text& text, std::string_view& line) {
  while (next_line(text, line)) {
    if (!line.empty() && line[0] != '#') return true;
  }
  return false;
}

void check_vertex(const Text& text, int vertex, std::size_t count) {
  if (vertex >= 0 && static_cast<std::size_t>(vertex) < count) return;
  fail(text, fmt::format("there is no vertex {} among {}, counted from 0", vertex, count));
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

std::string content_of(const std::filesystem::path& file) {
  return std::filesystem::exists(file) && std::filesystem::file_size(file) == 0 ? "" : read_file(file);
}

std::vector<IdentityGroup> read_identity_groups(const std::filesystem::path& set) {
  std::vector<IdentityGroup> groups;
  const std::filesystem::path file = set / "IDENTITY.corr.txt";
  if (!std::filesystem::exists(file)) return groups;
  const std::string content = content_of(file);
  Text text{file.string(), content};
  for (std::string_view line; next_line(text, line);) {
    // "# ... for every pair of: a b c  (843 vertices each)"
    if (line.empty()) continue;
    const auto colon = line.find(':'), bracket = line.rfind('(');
    if (colon == std::string::npos || bracket == std::string::npos || bracket < colon) {
      if (line[0] == '#') continue;  // a remark
      fail_malformed(text, line);
    }
    IdentityGroup group;
    group.line = text.line;
    std::istringstream names(std::string(line.substr(colon + 1, bracket - colon - 1)));
    for (std::string name; names >> name;) group.names.push_back(name);
    if (!(std::istringstream(std::string(line.substr(bracket + 1))) >> group.vertices) || group.names.empty()) fail_malformed(text, line);
    if (group.vertices < least_points) fail(text, "fewer than four vertices do not tell a map");
    groups.push_back(std::move(group));
  }
  return groups;
}

std::vector<std::pair<int, int>> read_vertex_pairs(const std::filesystem::path& file, std::size_t a_count, std::size_t b_count) {
  std::vector<std::pair<int, int>> pairs;
  const std::string content = content_of(file);
  Text text{file.string(), content};
  for (std::string_view line; next_entry(text, line);) {
    std::pair<int, int> pair;
    if (!(std::istringstream(std::string(line)) >> pair.first >> pair.second)) fail_malformed(text, line);
    check_vertex(text, pair.first, a_count);
    check_vertex(text, pair.second, b_count);
    pairs.push_back(pair);
  }
  if (pairs.size() < least_points) fail_at_end(text, pairs.size(), "pairs");
  return pairs;
}

std::vector<Landmark> read_landmarks(const std::filesystem::path& file) {
  std::vector<Landmark> landmarks;
  if (!std::filesystem::exists(file)) return landmarks;
  const std::string content = content_of(file);
  Text text{file.string(), content};
  for (std::string_view line; next_entry(text, line);) {
    Landmark landmark;
    Vec3& p = landmark.position;
    if (!(std::istringstream(std::string(line)) >> landmark.name >> p.x() >> p.y() >> p.z())) fail_malformed(text, line);
    landmarks.push_back(std::move(landmark));
  }
  if (landmarks.size() < least_points) fail_at_end(text, landmarks.size(), "landmarks");
  return landmarks;
}

std::vector<std::size_t> read_swap(const std::filesystem::path& file, const std::vector<Landmark>& landmarks) {
  if (!std::filesystem::exists(file)) return swap_by_names(landmarks);
  const std::string content = content_of(file);
  Text text{file.string(), content};
  std::vector<std::size_t> swap(landmarks.size());
  std::iota(swap.begin(), swap.end(), std::size_t{0});
  for (std::string_view line; next_entry(text, line);) {
    std::istringstream numbers{std::string(line)};
    std::size_t a = 0, b = 0;
    if (!(numbers >> a) || a >= landmarks.size()) fail_malformed(text, line);
    if (!(numbers >> b)) continue;
    if (b >= landmarks.size()) fail_malformed(text, line);
    swap[a] = b;
    swap[b] = a;
  }
  return swap;
}

}  // namespace homolog::bench
