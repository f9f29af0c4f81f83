// SPDX-License-Identifier: MIT
#include "homolog/shape/orient.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "homolog/shape/nested_boxes.h"
#include "homolog/shape/ray_crossing.h"
#include "homolog/shape/weld.h"

namespace homolog {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr double most_open = 0.25;  // |sum of area vectors| / area, 0 when closed, 1 for a flat patch: beyond it, volume says nothing

constexpr std::size_t triangles_a_row = 16, most_rows = 4096;

/// One side of a triangle: `key` names the edge whichever way it runs.
struct Side {
  std::uint64_t key;
  std::uint32_t triangle;
  bool forward;
};

struct Component {
  std::vector<std::uint32_t> triangles;
  std::vector<std::vector<std::uint32_t>> rows;  // of the same by height, once something is looked for in it
  Box box;
  double volume = 0;
  bool solid = false;   // closed enough for its volume to have a sign
  bool turned = false;  // to be turned as a whole
};

/// By edge, then by triangle. The lower vertex is sorted by counting, which leaves a handful of sides at a time to compare.
std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& vertex) {
  const auto lower_end = [&](const Triangle& t, int k) { return std::min(vertex[t[k]], vertex[t[(k + 1) % 3]]); };
  std::vector<std::uint32_t> begin(vertex.size() + 1, 0);
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) ++begin[lower_end(t, k) + 1];
  }
  for (std::size_t v = 0; v < vertex.size(); ++v) begin[v + 1] += begin[v];
  std::vector<Side> sides(3 * triangles.size());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::uint64_t a = vertex[triangles[t][k]], b = vertex[triangles[t][(k + 1) % 3]];
      sides[next[std::min(a, b)]++] = {std::min(a, b) << 32 | std::max(a, b), t, a < b};
    }
  }
  for (std::size_t v = 0; v < vertex.size(); ++v) {
    std::sort(sides.begin() + begin[v], sides.begin() + begin[v + 1],
              [](const Side& a, const Side& b) { return a.key != b.key ? a.key < b.key : a.triangle < b.triangle; });
  }
  return sides;
}

/// Calls body(first, last) for the sides of every edge.
template <class Body>
void for_each_edge(const std::vector<Side>& sides, const Body& body) {
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].key == sides[first].key) ++last;
    body(first, last);
  }
}

struct Neighbour {
  std::uint32_t triangle = std::numeric_limits<std::uint32_t>::max();
  bool disagrees = false;
};

struct Neighbourhood {
  std::vector<std::array<Neighbour, 3>> of;  // every triangle: up to three, over edges that exactly two triangles share
  bool in_order = true;                      // every edge has two sides, which run opposite ways: closed, and nothing is to be turned
};

Neighbourhood find_neighbours(const std::vector<Side>& sides, std::size_t triangle_count) {
  Neighbourhood neighbours{std::vector<std::array<Neighbour, 3>>(triangle_count)};
  std::vector<std::uint8_t> count(triangle_count, 0);
  for_each_edge(sides, [&](std::size_t first, std::size_t last) {
    const Side &a = sides[first], &b = sides[last - 1];
    const bool disagree = a.forward == b.forward;
    if (last - first != 2 || disagree) neighbours.in_order = false;
    if (last - first != 2) return;
    neighbours.of[a.triangle][count[a.triangle]++] = {b.triangle, disagree};
    neighbours.of[b.triangle][count[b.triangle]++] = {a.triangle, disagree};
  });
  return neighbours;
}

void turn(Triangle& triangle) { std::swap(triangle[1], triangle[2]); }

/// Turns the triangles that are marked; or the others, if these are most of the component's area.
void turn_fewer(const Component& component, const std::vector<std::uint8_t>& turned, std::vector<Triangle>& triangles, const Mesh& mesh) {
  double kept = 0;
  for (const std::uint32_t t : component.triangles) {
    const Vec3 &a = mesh.vertices[triangles[t][0]], &b = mesh.vertices[triangles[t][1]], &c = mesh.vertices[triangles[t][2]];
    kept += (turned[t] ? -1 : 1) * (b - a).cross(c - a).norm();
  }
  for (const std::uint32_t t : component.triangles) {
    if ((turned[t] != 0) == (kept >= 0)) turn(triangles[t]);
  }
}

/// Floods every component from its first triangle, turning triangles to agree with each other.
std::vector<Component> flood(std::vector<Triangle>& triangles, const Neighbourhood& neighbours, const Mesh& mesh) {
  std::vector<Component> components;
  std::vector<std::uint8_t> seen(triangles.size(), 0), turned(triangles.size(), 0);
  for (std::uint32_t seed = 0; seed < triangles.size(); ++seed) {
    if (seen[seed]) continue;
    Component component;
    component.triangles.push_back(seed);
    seen[seed] = 1;
    for (std::size_t next = 0; next < component.triangles.size(); ++next) {
      const std::uint32_t t = component.triangles[next];
      for (const Neighbour& neighbour : neighbours.of[t]) {
        if (neighbour.triangle >= triangles.size() || seen[neighbour.triangle]) continue;
        seen[neighbour.triangle] = 1;
        turned[neighbour.triangle] = turned[t] != neighbour.disagrees;
        component.triangles.push_back(neighbour.triangle);
      }
    }
    if (!neighbours.in_order) turn_fewer(component, turned, triangles, mesh);
    components.push_back(std::move(component));
  }
  return components;
}

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

/// Turns reversed outermost solids together with everything in them, so that the cavities of a wholly reversed solid stay cavities.
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
    for (const std::uint32_t t : component.triangles) turn(triangles[t]);
  }
}

/// The share of sides that no other one passes in the other direction, after the triangles have been turned.
double open_share(const std::vector<Side>& sides, const std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& vertex) {
  const auto passes_forward = [&](const Side& side) {
    const auto& [a, b, c] = triangles[side.triangle];
    const std::uint64_t u = vertex[a], v = vertex[b], w = vertex[c];
    return side.key == (u << 32 | v) || side.key == (v << 32 | w) || side.key == (w << 32 | u);
  };
  std::size_t open = 0;
  for_each_edge(sides, [&](std::size_t first, std::size_t last) {
    int sum = 0;
    for (std::size_t i = first; i < last; ++i) sum += passes_forward(sides[i]) ? 1 : -1;
    open += static_cast<std::size_t>(std::abs(sum));
  });
  return sides.empty() ? 0 : static_cast<double>(open) / static_cast<double>(sides.size());
}

/// A triangle by its corners' places, the lowest first, then which way round they come.
struct Face {
  Triangle corners;
  bool front;
  std::uint32_t number;
};

Face face_of(const Triangle& t, const std::vector<std::uint32_t>& vertex, std::uint32_t number) {
  Triangle c{vertex[t[0]], vertex[t[1]], vertex[t[2]]};
  std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  const bool front = c[1] < c[2];
  if (!front) std::swap(c[1], c[2]);
  return {c, front, number};
}

/// Leaves out copies; true when there were any. Only triangles at edges of more than two can have one.
bool leave_out_copies(const std::vector<Side>& sides, const std::vector<std::uint32_t>& vertex, std::vector<Triangle>& triangles) {
  std::vector<std::uint8_t> crowded(triangles.size(), 0), copy(triangles.size(), 0);
  for_each_edge(sides, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last && last - first > 2; ++i) crowded[sides[i].triangle] = 1;
  });
  std::vector<Face> faces;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (crowded[t]) faces.push_back(face_of(triangles[t], vertex, t));
  }
  std::sort(faces.begin(), faces.end(),
            [](const Face& a, const Face& b) { return std::tie(a.corners, a.front, a.number) < std::tie(b.corners, b.front, b.number); });
  std::size_t copies = 0;
  std::vector<std::uint32_t> second_sides;
  for (std::size_t i = 1; i < faces.size(); ++i) {
    if (faces[i].corners != faces[i - 1].corners) continue;
    if (faces[i].front != faces[i - 1].front) {
      second_sides.push_back(faces[i].number);
    } else {
      copy[faces[i].number] = 1;
      ++copies;
    }
  }
  if (!second_sides.empty() && 2 * second_sides.size() == triangles.size() - copies) {
    for (const std::uint32_t t : second_sides) copy[t] = 1;
    copies += second_sides.size();
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!copy[t]) triangles[kept++] = triangles[t];
  }
  triangles.resize(kept);
  return copies > 0;
}

}  // namespace

OrientedSurface orient(const Mesh& mesh) {
  const std::vector<std::uint32_t> vertex = first_equal_vertex(mesh.vertices);
  OrientedSurface surface;
  for (const Triangle& t : mesh.triangles) {
    if (vertex[t[0]] != vertex[t[1]] && vertex[t[1]] != vertex[t[2]] && vertex[t[2]] != vertex[t[0]]) surface.triangles.push_back(t);
  }
  std::vector<Side> sides = sorted_sides(surface.triangles, vertex);
  if (leave_out_copies(sides, vertex, surface.triangles)) sides = sorted_sides(surface.triangles, vertex);
  const Neighbourhood neighbours = find_neighbours(sides, surface.triangles.size());
  std::vector<Component> components = flood(surface.triangles, neighbours, mesh);
  for (Component& component : components) measure(component, surface.triangles, mesh);
  turn_components(components, surface.triangles, mesh);
  surface.components = components.size();
  surface.open = neighbours.in_order ? 0 : open_share(sides, surface.triangles, vertex);
  return surface;
}

}  // namespace homolog
