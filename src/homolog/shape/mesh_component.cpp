// SPDX-License-Identifier: MIT
#include "homolog/shape/mesh_component.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "homolog/shape/nested_boxes.h"
#include "homolog/shape/ray_crossing.h"

namespace homolog {
namespace {

constexpr double most_open = 0.25;  // |sum of area vectors| / area, 0 when closed, 1 for a flat patch: beyond it, volume says nothing

constexpr std::size_t most_cells = 1024;     // along either axis
constexpr std::size_t cells_a_triangle = 4;  // in the mean, at most

/// The cell along y (axis 1) or z (axis 2) in which a coordinate lies; higher ones lie in no lower cell.
std::size_t cell_of(double x, int axis, const Component& component) {
  const double share = (x - component.box.min[axis]) / (component.box.max[axis] - component.box.min[axis]);
  const std::size_t side = component.cells.side;
  return share > 0 ? std::min(side - 1, static_cast<std::size_t>(std::min(share, 1.0) * static_cast<double>(side))) : 0;
}

struct CellRange {
  std::size_t first[2], last[2];  // along y and z
  std::size_t count() const { return (last[0] - first[0] + 1) * (last[1] - first[1] + 1); }
};

CellRange cells_of(const Triangle& triangle, const Component& component, const Mesh& mesh) {
  const Vec3 &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]], &c = mesh.vertices[triangle[2]];
  const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  const double rounding = 1e-15 * (std::abs(low.y()) + std::abs(high.y()));  // of where a row of rays is cut
  return {{cell_of(low.y() - rounding, 1, component), cell_of(low.z(), 2, component)},
          {cell_of(high.y() + rounding, 1, component), cell_of(high.z(), 2, component)}};
}

/// As many cells as triangles where these are as small as they would be on a ball; in a sponge they are larger, and all lie in many.
std::size_t side_for(Component& component, const std::vector<Triangle>& triangles, const Mesh& mesh) {
  const std::size_t most = cells_a_triangle * component.triangles.size();
  const auto root = static_cast<std::size_t>(std::sqrt(static_cast<double>(component.triangles.size())));
  for (component.cells.side = std::min(root, most_cells); component.cells.side > 1; component.cells.side /= 2) {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < component.triangles.size() && sum <= most; ++i)
      sum += cells_of(triangles[component.triangles[i]], component, mesh).count();
    if (sum <= most) break;
  }
  return std::max<std::size_t>(component.cells.side, 1);
}

/// Sorts the triangles by where rays along x meet them, as a shape may have thousands of cavities that are looked for in it.
void sort_into_cells(Component& component, const std::vector<Triangle>& triangles, const Mesh& mesh) {
  RayCells& cells = component.cells;
  cells.side = side_for(component, triangles, mesh);
  cells.end.assign(cells.side * cells.side, 0);
  const auto each = [&](const auto& act) {
    for (const std::uint32_t t : component.triangles) {
      const CellRange range = cells_of(triangles[t], component, mesh);
      for (std::size_t z = range.first[1]; z <= range.last[1]; ++z) {
        for (std::size_t y = range.first[0]; y <= range.last[0]; ++y) act(cells.end[z * cells.side + y], t);
      }
    }
  };
  each([](std::size_t& end, std::uint32_t) { ++end; });
  std::size_t sum = 0;
  for (std::size_t& end : cells.end) sum += std::exchange(end, sum);  // first the begin, which filling moves to the end
  cells.triangles.resize(sum);
  each([&](std::size_t& end, std::uint32_t t) { cells.triangles[end++] = t; });
}

bool lies_in(const Vec3& point, const Component& outer, const std::vector<Triangle>& triangles, const Mesh& mesh) {
  const std::size_t cell = cell_of(point.z(), 2, outer) * outer.cells.side + cell_of(point.y(), 1, outer);
  int winding = 0;
  for (std::size_t i = cell == 0 ? 0 : outer.cells.end[cell - 1]; i < outer.cells.end[cell]; ++i) {
    const auto& [a, b, c] = triangles[outer.cells.triangles[i]];
    winding += crossing_beyond(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], point);
  }
  return winding != 0;
}

/// Whether one solid lies wholly in another one, judged at a few of its corners.
bool lies_in(const Component& inner, Component& outer, const std::vector<Triangle>& triangles, const Mesh& mesh) {
  if ((inner.box.min.array() <= outer.box.min.array()).any() || (inner.box.max.array() >= outer.box.max.array()).any()) return false;
  if (outer.cells.end.empty()) sort_into_cells(outer, triangles, mesh);
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
