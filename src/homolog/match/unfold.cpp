// SPDX-License-Identifier: MIT
#include "homolog/match/unfold.h"

#include <algorithm>

#include "homolog/shape/weld.h"

namespace homolog {
namespace {

constexpr int rounds = 8;
constexpr double steps[] = {1, 0.5, 1.5};  // of the way to the mean of the neighbours, the first that helps

/// Works on the places of first vertices alone: of those in one place (weld.h).
class Unfolding {
 public:
  Unfolding(Places& places, const LaidMesh& laid, double farthest)
      : places_(places),
        before_(places),
        laid_(laid),
        farthest_(farthest),
        first_(first_equal_vertex(laid.mesh.vertices)),
        around_(places.size()) {
    for (std::uint32_t t = 0; t < laid.mesh.triangles.size(); ++t) {
      if (!has_places(t)) continue;
      for (const std::uint32_t corner : laid.mesh.triangles[t]) around_[first_[corner]].push_back(t);
    }
  }

  /// The corners of folded triangles.
  std::vector<std::uint32_t> crumpled() const {
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t t = 0; t < laid_.mesh.triangles.size(); ++t) {
      if (!has_places(t) || !(upright_area(t) < 0)) continue;
      for (const std::uint32_t corner : laid_.mesh.triangles[t]) vertices.push_back(first_[corner]);
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  /// Whether the vertex found a place about which less is folded.
  bool draw(std::uint32_t vertex) {
    const Vec3 middle = middle_around(vertex);
    for (const double step : steps) {
      const SurfacePlace here = *places_[vertex];
      const Fold fold = fold_about(vertex);
      const auto place =
          laid_.surface.nearest(here.position + step * (middle - here.position), laid_.facing[vertex], farthest_, here.triangle);
      if (!place || (place->position - before_[vertex]->position).norm() > farthest_) continue;
      places_[vertex] = place;
      const Fold now = fold_about(vertex);
      if (now.triangles <= fold.triangles && now.area < fold.area) return true;
      places_[vertex] = here;
    }
    return false;
  }

  /// Vertices in one place of the mesh have one place here.
  void share_places() {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (places_[i] && places_[first_[i]]) places_[i] = places_[first_[i]];
    }
  }

 private:
  struct Fold {
    int triangles = 0;
    double area = 0;  ///< twice that of all
  };

  bool has_places(std::uint32_t triangle) const {
    const auto& corners = laid_.mesh.triangles[triangle];
    return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) { return places_[first_[corner]].has_value(); });
  }

  /// Twice the area, below nothing of a folded triangle.
  double upright_area(std::uint32_t triangle) const {
    const auto& [a, b, c] = laid_.mesh.triangles[triangle];
    const SurfacePlace &p = *places_[first_[a]], &q = *places_[first_[b]], &r = *places_[first_[c]];
    const Vec3 outward =
        laid_.surface.between(p, laid_.outward) + laid_.surface.between(q, laid_.outward) + laid_.surface.between(r, laid_.outward);
    const Vec3 at = at_rest(p);
    const double area = (at_rest(q) - at).cross(at_rest(r) - at).dot(outward.normalized());
    return laid_.mirrored ? -area : area;
  }

  Vec3 at_rest(const SurfacePlace& place) const { return laid_.surface.between(place, laid_.at_rest.vertices); }

  Fold fold_about(std::uint32_t vertex) const {
    Fold fold;
    for (const std::uint32_t triangle : around_[vertex]) {
      if (const double area = upright_area(triangle); area < 0) ++fold.triangles, fold.area -= area;
    }
    return fold;
  }

  Vec3 middle_around(std::uint32_t vertex) const {
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (const std::uint32_t triangle : around_[vertex]) {
      for (const std::uint32_t corner : laid_.mesh.triangles[triangle]) {
        if (first_[corner] != vertex) sum += places_[first_[corner]]->position, ++count;
      }
    }
    return sum / count;
  }

  Places& places_;
  const Places before_;
  const LaidMesh& laid_;
  double farthest_;
  std::vector<std::uint32_t> first_;
  std::vector<std::vector<std::uint32_t>> around_;  ///< the triangles about each first vertex
};

}  // namespace

void unfold(Places& places, const LaidMesh& laid, double farthest) {
  Unfolding unfolding(places, laid, farthest);
  for (int round = 0; round < rounds; ++round) {
    bool drawn = false;
    for (const std::uint32_t vertex : unfolding.crumpled()) drawn |= unfolding.draw(vertex);
    if (!drawn) break;
  }
  unfolding.share_places();
}

}  // namespace homolog
