// SPDX-License-Identifier: MIT
#include "homolog/shape/surface_nets.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace homolog {
namespace {

constexpr float level = 0.5f;
constexpr double inward = 0.5, outward = -0.52;  // a step of smoothing and the step that undoes its shrinking [taubin1995]
constexpr auto none = std::numeric_limits<std::uint32_t>::max();

/// Slices with one empty value around; cell (x, y) lies between the values (x, y) and (x + 1, y + 1) of two of them.
struct Net {
  const SliceField& field;
  const IsStill& is_still;
  std::size_t width, height;            // of a padded slice
  std::vector<float> below, above;      // the values of two neighbouring slices
  std::vector<std::uint32_t> old, now;  // the vertices of the cells under `below` and between the two
  std::vector<Vec3> vertices, middles;  // middles: of their cells
  std::vector<bool> still;              // vertices that are not smoothed
  std::vector<std::array<std::uint32_t, 4>> quads;
};

void load(Net& net, int z, std::vector<float>& padded) {
  std::fill(padded.begin(), padded.end(), 0.0f);
  if (z < 0 || z >= net.field.size[2]) return;
  std::vector<float> slice(static_cast<std::size_t>(net.field.size[0]) * net.field.size[1]);
  net.field.fill(z, slice);
  for (int y = 0; y < net.field.size[1]; ++y) {
    const auto row = slice.begin() + static_cast<std::ptrdiff_t>(y) * net.field.size[0];
    std::copy(row, row + net.field.size[0], padded.begin() + static_cast<std::ptrdiff_t>((y + 1) * net.width + 1));
  }
}

/// The mean of the crossings of a cell's twelve edges, in the cell from 0 to 1; false when the surface does not pass it.
bool mean_crossing(const std::array<float, 8>& corner, Vec3& mean) {
  int crossings = 0;
  mean.setZero();
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 8; ++i) {
      const int j = i | 1 << axis;
      if (i == j || (corner[i] > level) == (corner[j] > level)) continue;
      Vec3 place(i & 1, i >> 1 & 1, i >> 2 & 1);
      place[axis] = (level - corner[i]) / (corner[j] - corner[i]);
      mean += place;
      ++crossings;
    }
  }
  if (crossings > 0) mean /= crossings;
  return crossings > 0;
}

void place_vertices(Net& net, int z) {
  for (std::size_t y = 0; y + 1 < net.height; ++y) {
    for (std::size_t x = 0; x + 1 < net.width; ++x) {
      const std::size_t i = y * net.width + x, up = i + net.width;
      const std::array<float, 8> corner{net.below[i], net.below[i + 1], net.below[up], net.below[up + 1],
                                        net.above[i], net.above[i + 1], net.above[up], net.above[up + 1]};
      Vec3 mean;
      net.now[i] = none;
      if (!mean_crossing(corner, mean)) continue;
      net.now[i] = static_cast<std::uint32_t>(net.vertices.size());
      const std::array<int, 3> cell{static_cast<int>(x) - 1, static_cast<int>(y) - 1, z};  // the padding comes off
      const Vec3 origin(cell[0], cell[1], cell[2]);
      net.middles.push_back(origin + Vec3::Constant(0.5));
      net.still.push_back(net.is_still && net.is_still(cell));
      net.vertices.push_back(net.still.back() ? net.middles.back() : origin + mean);
    }
  }
}

/// The four cells around an edge between two values, in such an order that the front looks from the one inside to the other.
void add_quad(Net& net, bool from_inside, std::array<std::uint32_t, 4> cells) {
  if (!from_inside) std::swap(cells[1], cells[3]);
  net.quads.push_back(cells);
}

void add_quads(Net& net) {
  for (std::size_t y = 0; y + 1 < net.height; ++y) {
    for (std::size_t x = 0; x + 1 < net.width; ++x) {
      const std::size_t i = y * net.width + x, left = i - 1, down = i - net.width, corner = down - 1;
      const bool inside = net.below[i] > level;
      const auto differs = [&](float other) { return (other > level) != inside; };
      if (y > 0 && differs(net.below[i + 1])) add_quad(net, inside, {net.old[down], net.old[i], net.now[i], net.now[down]});
      if (x > 0 && differs(net.below[i + net.width])) add_quad(net, inside, {net.old[left], net.now[left], net.now[i], net.old[i]});
      if (x > 0 && y > 0 && differs(net.above[i])) add_quad(net, inside, {net.now[corner], net.now[down], net.now[i], net.now[left]});
    }
  }
}

/// Moves every vertex by a share of the way to the mean of its neighbours.
void smooth(Net& net, double share) {
  std::vector<Vec3> sums(net.vertices.size(), Vec3::Zero());
  std::vector<int> counts(net.vertices.size(), 0);
  for (const auto& quad : net.quads) {
    for (int k = 0; k < 4; ++k) {
      const std::uint32_t a = quad[k], b = quad[(k + 1) % 4];
      sums[a] += net.vertices[b];
      sums[b] += net.vertices[a];
      ++counts[a];
      ++counts[b];
    }
  }
  const Vec3 half = Vec3::Constant(0.5);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (net.still[i]) continue;
    const Vec3 moved = net.vertices[i] + share * (sums[i] / counts[i] - net.vertices[i]);
    net.vertices[i] = moved.cwiseMax(net.middles[i] - half).cwiseMin(net.middles[i] + half);
  }
}

}  // namespace

Mesh surface_nets(const SliceField& field, int rounds, const IsStill& is_still) {
  const auto width = static_cast<std::size_t>(field.size[0]) + 2, height = static_cast<std::size_t>(field.size[1]) + 2;
  const std::vector<float> empty(width * height, 0);
  const std::vector<std::uint32_t> no_cells(width * height, none);
  Net net{field, is_still, width, height, empty, empty, no_cells, no_cells, {}, {}, {}, {}};
  for (int z = -1; z < field.size[2]; ++z) {
    load(net, z + 1, net.above);
    place_vertices(net, z);
    add_quads(net);
    net.below.swap(net.above);
    net.old.swap(net.now);
  }
  for (int round = 0; round < rounds; ++round) {
    smooth(net, inward);
    smooth(net, outward);
  }
  Mesh mesh{std::move(net.vertices), {}};
  for (const auto& [a, b, c, d] : net.quads) mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
  return mesh;
}

}  // namespace homolog
