// SPDX-License-Identifier: MIT
#include "homolog/shape/mesh_component.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "homolog/shape/nested_boxes.h"
#include "homolog/shape/ray_crossing.h"

namespace homolog {
namespace {

constexpr double most_open = 0.25;  // |sum of area vectors| / area, 0 when closed, 1 for a flat patch: beyond it, volume says nothing

constexpr std::size_t triangles_a_row = 16, most_rows = 4096;

/// The row of a component's triangles that a height lies in; higher ones lie in no lower row.
std::size_t row_of(double z, const Component& component) {
  const double share = (z - component.box.min.z()) / (component.box.max.z() - component.box.min.z());
  const std::size_t last = component.rows.size() - 1;
  return share > 0 ? std::min(last, static_cast<std::size_t>(std::min(share, 1.0) * static_cast<double>(last))) : 0;
}

/// Sorts the triangles by height, as a shape may have thousands of cavities that are looked for in it.
void sort_into_rows(Component& component, const std::vector<Triangle>& triangles, const Mesh& mesh) {
  component.rows.resize(std::clamp<std::size_t>(component.triangles.size() / triangles_a_row, 1, most_rows));
  for (const std::uint32_t t : component.triangles) {
    const auto& [a, b, c] = triangles[t];
    const auto [low, high] = std::minmax({mesh.vertices[a].z(), mesh.vertices[b].z(), mesh.vertices[c].z()});
    for (std::size_t row = row_of(low, component); row <= row_of(high, component); ++row) component.rows[row].push_back(t);
  }
}

bool lies_in(const Vec3& point, const Component& outer, const std::vector<Triangle>& triangles, const Mesh& mesh) {
  int winding = 0;
  for (const std::uint32_t t : outer.rows[row_of(point.z(), outer)]) {
    const auto& [a, b, c] = triangles[t];
    winding += crossing_beyond(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], point);
  }
  return winding != 0;
}

/// Whether one solid lies wholly in another one, judged at a few of its corners.
bool lies_in(const Component& inner, Component& outer, const std::vector<Triangle>& triangles, const Mesh& mesh) {
  if ((inner.box.min.array() <= outer.box.min.array()).any() || (inner.box.max.array() >= outer.box.max.array()).any()) return false;
  if (outer.rows.empty()) sort_into_rows(outer, triangles, mesh);
  const std::size_t step = std::max<std::size_t>(1, inner.triangles.size() / 4);
  for (std::size_t i = 0; i < inner.triangles.size(); i += step) {
    if (!lies_in(mesh.vertices[triangles[inner.triangles[i]][0]], outer, triangles, mesh)) return false;
  }
  return true;
}

}  // namespace

void measure(Component& component, const std::vector<Triangle>& triangles, const Mesh& mesh) {
  const Vec3& origin = mesh.vertices[triangles[component.triangles[0]][0]];
  component.box = {origin, origin};
  for (const std::uint32_t t : component.triangles) {
    for (const std::uint32_t corner : triangles[t]) {
      component.box.min = component.box.min.cwiseMin(mesh.vertices[corner]);
      component.box.max = component.box.max.cwiseMax(mesh.vertices[corner]);
    }
  }
  const Vec3 centre = (component.box.min + component.box.max) / 2;
  Vec3 area_vector = Vec3::Zero();
  double area = 0;
  for (const std::uint32_t t : component.triangles) {
    const Vec3 a = mesh.vertices[triangles[t][0]] - centre, b = mesh.vertices[triangles[t][1]] - centre,
               c = mesh.vertices[triangles[t][2]] - centre;
    const Vec3 normal = (b - a).cross(c - a);
    area_vector += normal;
    area += normal.norm();
    component.volume += a.dot(b.cross(c)) / 6;
  }
  component.solid = area_vector.norm() < most_open * area;
}

void turn_components(std::vector<Component>& components, std::vector<Triangle>& triangles, const Mesh& mesh) {
  std::vector<Component*> order;
  for (Component& component : components) {
    if (component.solid) order.push_back(&component);
  }
  std::stable_sort(order.begin(), order.end(), [](auto* a, auto* b) { return std::abs(a->volume) > std::abs(b->volume); });
  if (std::none_of(order.begin(), order.end(), [](auto* solid) { return solid->volume < 0; })) return;
  std::vector<Box> boxes;
  for (const Component* solid : order) boxes.push_back(solid->box);
  const NestedBoxes nested(boxes);
  bool any_turned = false;
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    Component& inner = *order[i];
    const Component* around = nullptr;
    if (inner.volume < 0 || any_turned) {
      for (const std::uint32_t k : nested.around(inner.box.min)) {
        if (k >= i || around) break;
        const bool matters = inner.volume < 0 || order[k]->turned;  // two solids the right way round need no look
        if (matters && lies_in(inner, *order[k], triangles, mesh)) around = order[k];
      }
    }
    inner.turned = around ? around->turned : inner.volume < 0;
    any_turned |= inner.turned;
  }
  for (const Component& component : components) {
    if (!component.turned) continue;
    for (const std::uint32_t t : component.triangles) turn_over(triangles[t]);
  }
}

}  // namespace homolog
