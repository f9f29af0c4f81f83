// SPDX-License-Identifier: MIT
#include "cut_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

namespace homolog::bench {
namespace {

// Builds the part triangle by triangle; a corner on the far side gives way to the points where its edges cross the plane.
class Cutter {
 public:
  Cutter(const Mesh& whole, const Vec3& normal, double offset) : whole_(whole), number_(whole.vertices.size(), -1) {
    for (const Vec3& v : whole.vertices) height_.push_back(v.dot(normal) - offset);
    for (std::size_t i = 0; i < whole.vertices.size(); ++i) {
      if (height_[i] <= 0) continue;
      number_[i] = static_cast<int>(part_.whole_vertex.size());
      part_.whole_vertex.push_back(static_cast<int>(i));
      part_.mesh.vertices.push_back(whole.vertices[i]);
    }
  }

  CutPart run() {
    for (const auto& t : whole_.triangles) add(t);
    close();
    return std::move(part_);
  }

 private:
  std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
    const auto [place, is_new] = crossings_.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(part_.mesh.vertices.size()));
    if (is_new) {
      const double t = height_[a] / (height_[a] - height_[b]);
      part_.mesh.vertices.push_back((1 - t) * whole_.vertices[a] + t * whole_.vertices[b]);
    }
    return place->second;
  }

  void add(const Triangle& triangle) {
    std::vector<std::uint32_t> corners;
    std::uint32_t leave = 0, enter = 0;
    bool crosses = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
      if (number_[a] >= 0) corners.push_back(static_cast<std::uint32_t>(number_[a]));
      if ((number_[a] >= 0) == (number_[b] >= 0)) continue;
      corners.push_back(crossing(a, b));
      (number_[a] >= 0 ? leave : enter) = corners.back();
      crosses = true;
    }
    for (std::size_t k = 2; k < corners.size(); ++k) part_.mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
    if (crosses) rim_.emplace_back(leave, enter);
  }

  // Each rim edge runs from where its triangle leaves the part to where it enters again; the cap must run it backwards.
  void close() {
    if (rim_.empty()) return;
    Vec3 middle = Vec3::Zero();
    for (const auto& [leave, enter] : rim_) middle += part_.mesh.vertices[leave] / static_cast<double>(rim_.size());
    const auto centre = static_cast<std::uint32_t>(part_.mesh.vertices.size());
    part_.mesh.vertices.push_back(middle);
    for (const auto& [leave, enter] : rim_) part_.mesh.triangles.push_back({enter, leave, centre});
  }

  const Mesh& whole_;
  std::vector<double> height_;
  std::vector<int> number_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> rim_;
  CutPart part_;
};

}  // namespace

double volume_of(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) sum += mesh.vertices[a].cross(mesh.vertices[b]).dot(mesh.vertices[c]);
  return sum / 6;
}

bool is_closed(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> surplus;  // of edges one way over those the other way
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      surplus[std::minmax(a, b)] += int{a < b} - int{b < a};
    }
  }
  return std::ranges::all_of(surplus, [](const auto& edge) { return edge.second == 0; });
}

CutPart cut(const Mesh& whole, const Vec3& normal, double offset) { return Cutter(whole, normal, offset).run(); }

CutPart cut_share(const Mesh& whole, const Vec3& normal, double share) {
  double low = whole.vertices.front().dot(normal), high = low;
  for (const Vec3& v : whole.vertices) low = std::min(low, v.dot(normal)), high = std::max(high, v.dot(normal));
  const double wanted = share * volume_of(whole);
  for (int step = 0; step < 24; ++step) {
    const double middle = (low + high) / 2;
    (volume_of(cut(whole, normal, middle).mesh) > wanted ? low : high) = middle;
  }
  return cut(whole, normal, (low + high) / 2);
}

}  // namespace homolog::bench
