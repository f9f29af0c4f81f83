// SPDX-License-Identifier: MIT
#include "homolog/shape/orient.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "homolog/shape/mesh_component.h"
#include "homolog/shape/weld.h"

namespace homolog {
namespace {

constexpr double seam_gap = 1e-5;  // of the diagonal: what rounding leaves between corners that were one
constexpr double least_side = 10;  // gaps, of triangles whose corners are welded

/// One side of a triangle: `key` names the edge whichever way it runs.
struct Side {
  std::uint64_t key;
  std::uint32_t triangle;
  bool forward;
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

/// Vertices at sides that run along no other.
std::vector<std::uint8_t> open_vertices(const std::vector<Side>& sides, std::size_t count) {
  std::vector<std::uint8_t> open(count, 0);
  for_each_edge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first == 1) open[sides[first].key >> 32] = open[sides[first].key & 0xffffffff] = 1;
  });
  return open;
}

/// Keeps the corners of triangles with a side below `least` where they are.
void fasten_small_triangles(const std::vector<Triangle>& triangles, const Mesh& mesh, const std::vector<std::uint32_t>& vertex,
                            double least, std::vector<std::uint8_t>& loose) {
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = vertex[t[k]], b = vertex[t[(k + 1) % 3]];
      if ((mesh.vertices[a] - mesh.vertices[b]).norm() < least) loose[a] = loose[b] = 0;
    }
  }
}

/// Closes seams whose corners lie a little apart, for the triangles and `vertex`; false when there are none.
bool weld_seams(const std::vector<Side>& sides, const Mesh& mesh, std::vector<std::uint32_t>& vertex, std::vector<Triangle>& triangles) {
  std::vector<std::uint8_t> loose = open_vertices(sides, vertex.size());
  if (std::find(loose.begin(), loose.end(), 1) == loose.end()) return false;
  const double gap = seam_gap * bounding_box(mesh).diagonal();
  fasten_small_triangles(triangles, mesh, vertex, least_side * gap, loose);
  const std::vector<std::uint32_t> leader = nearest_leader(mesh.vertices, loose, gap);
  if (std::all_of(vertex.begin(), vertex.end(), [&](std::uint32_t v) { return leader[v] == v; })) return false;
  for (std::uint32_t& v : vertex) v = leader[v];
  for (Triangle& t : triangles) {
    for (std::uint32_t& corner : t) corner = vertex[corner];
  }
  return true;
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

/// Turns the triangles that are marked; or the others, if these are most of the component's area.
void turn_fewer(const Component& component, const std::vector<std::uint8_t>& turned, std::vector<Triangle>& triangles, const Mesh& mesh) {
  double kept = 0;
  for (const std::uint32_t t : component.triangles) {
    const Vec3 &a = mesh.vertices[triangles[t][0]], &b = mesh.vertices[triangles[t][1]], &c = mesh.vertices[triangles[t][2]];
    kept += (turned[t] ? -1 : 1) * (b - a).cross(c - a).norm();
  }
  for (const std::uint32_t t : component.triangles) {
    if ((turned[t] != 0) == (kept >= 0)) turn_over(triangles[t]);
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
  if (!front) turn_over(c);
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
  std::vector<std::uint32_t> vertex = first_equal_vertex(mesh.vertices);
  OrientedSurface surface;
  for (const Triangle& t : mesh.triangles) {
    if (vertex[t[0]] != vertex[t[1]] && vertex[t[1]] != vertex[t[2]] && vertex[t[2]] != vertex[t[0]]) surface.triangles.push_back(t);
  }
  std::vector<Side> sides = sorted_sides(surface.triangles, vertex);
  if (weld_seams(sides, mesh, vertex, surface.triangles)) sides = sorted_sides(surface.triangles, vertex);
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
