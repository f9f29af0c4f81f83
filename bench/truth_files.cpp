// SPDX-License-Identifier: MIT
#include "truth_files.h"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <numeric>
#include <sstream>

#include "homolog/base/errors.h"

namespace homolog::bench {
namespace {

FileError malformed(const std::filesystem::path& file, const std::string& line) {
  return FileError(fmt::format("{}: cannot understand '{}'", file.string(), line));
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
  std::ifstream in(set / "IDENTITY.corr.txt");
  for (std::string line; std::getline(in, line);) {
    // "... for every pair of: a b c  (843 vertices each)"
    const auto colon = line.find(':'), bracket = line.rfind('(');
    if (colon == std::string::npos || bracket == std::string::npos || bracket < colon) continue;
    IdentityGroup group;
    std::istringstream names(line.substr(colon + 1, bracket - colon - 1));
    for (std::string name; names >> name;) group.names.push_back(name);
    if (!(std::istringstream(line.substr(bracket + 1)) >> group.vertices)) throw malformed(set / "IDENTITY.corr.txt", line);
    groups.push_back(std::move(group));
  }
  return groups;
}

std::vector<std::pair<int, int>> read_vertex_pairs(const std::filesystem::path& file) {
  std::vector<std::pair<int, int>> pairs;
  std::ifstream in(file);
  if (!in) throw FileError(fmt::format("{}: cannot be read", file.string()));
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::pair<int, int> pair;
    if (!(std::istringstream(line) >> pair.first >> pair.second)) throw malformed(file, line);
    pairs.push_back(pair);
  }
  return pairs;
}

std::vector<Landmark> read_landmarks(const std::filesystem::path& file) {
  std::vector<Landmark> landmarks;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    Landmark landmark;
    Vec3& p = landmark.position;
    if (!(std::istringstream(line) >> landmark.name >> p.x() >> p.y() >> p.z())) throw malformed(file, line);
    landmarks.push_back(std::move(landmark));
  }
  return landmarks;
}

std::vector<std::size_t> read_swap(const std::filesystem::path& file, const std::vector<Landmark>& landmarks) {
  std::ifstream in(file);
  if (!in) return swap_by_names(landmarks);
  std::vector<std::size_t> swap(landmarks.size());
  std::iota(swap.begin(), swap.end(), std::size_t{0});
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream numbers(line);
    std::size_t a = 0, b = 0;
    if (!(numbers >> a) || a >= landmarks.size()) throw malformed(file, line);
    if (!(numbers >> b)) continue;
    if (b >= landmarks.size()) throw malformed(file, line);
    swap[a] = b;
    swap[b] = a;
  }
  return swap;
}

}  // namespace homolog::bench
