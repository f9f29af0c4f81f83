// SPDX-License-Identifier: MIT
// What vectors and layers find, against one ray after the other.
#include "homolog/shape/axis_sums.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fixtures/solids.h"
#include "homolog/base/parallel.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

using Voxel = std::array<int, 3>;

struct Sums {
  std::array<std::vector<double>, 3> sums, lost;  // by axis, per voxel, x fastest
};

std::size_t index_of(const GridSurface& surface, const Voxel& v) {
  return (static_cast<std::size_t>(v[2]) * surface.size[1] + v[1]) * surface.size[0] + v[0];
}

struct Place {
  double middle, width;
};

Place place_of(int ray, double part_min, double part_max) {
  const double low = std::max(part_min, ray / 4.0), high = std::min(part_max, (ray + 1) / 4.0);
  return {(low + high) / 2, std::max(0.0, 4 * (high - low))};
}

/// One ray along an axis: where it is inside, and whether it closes.
void follow_ray(const GridSurface& surface, const RayAxes& axes, int column, int row, Sums& sums) {
  const Place c = place_of(column, surface.part.min[axes.column], surface.part.max[axes.column]);
  const Place r = place_of(row, surface.part.min[axes.row], surface.part.max[axes.row]);
  std::vector<std::pair<double, int>> crossings;
  int winding = 0;
  for (const auto& [i, j, k] : surface.triangles) {
    RowCut cut;
    if (!cut_row(surface.vertices[i], surface.vertices[j], surface.vertices[k], axes, r.middle, cut)) continue;
    if (c.middle < cut.from || c.middle >= cut.to) continue;
    crossings.emplace_back(cut.depth_at(c.middle), cut.sign);
    winding += cut.sign;
  }
  const bool closes = winding == 0;
  std::sort(crossings.begin(), crossings.end());
  Voxel voxel;
  voxel[axes.column] = column / 4, voxel[axes.row] = row / 4;
  for (int depth = 0; depth < surface.size[axes.depth]; ++depth) {
    voxel[axes.depth] = depth;
    if (!closes) sums.lost[axes.depth][index_of(surface, voxel)] += c.width * r.width;
    const double low = std::max<double>(depth, surface.part.min[axes.depth]);
    const double high = std::min(depth + 1.0, surface.part.max[axes.depth]);
    for (std::size_t n = 0; closes && n + 1 < crossings.size(); ++n) {
      winding += crossings[n].second;
      const double inside = std::min(high, crossings[n + 1].first) - std::max(low, crossings[n].first);
      if (winding != 0) sums.sums[axes.depth][index_of(surface, voxel)] += std::max(0.0, inside) * c.width * r.width;
    }
    winding = 0;
  }
}

Sums ray_by_ray(const GridSurface& surface) {
  Sums sums;
  for (const RayAxes& axes : ray_axes) {
    sums.sums[axes.depth].assign(surface.voxels(), 0);
    sums.lost[axes.depth].assign(surface.voxels(), 0);
    for (int row = 0; row < 4 * surface.size[axes.row]; ++row) {
      for (int column = 0; column < 4 * surface.size[axes.column]; ++column) follow_ray(surface, axes, column, row, sums);
    }
  }
  return sums;
}

Sums by_layers(const GridSurface& surface) {
  Sums sums;
  for (int axis = 0; axis < 3; ++axis) {
    sums.sums[axis].assign(surface.voxels(), -1);
    sums.lost[axis].assign(surface.voxels(), -1);
  }
  visit_axis_sums(surface, [&](const RowSums& row) {
    for (int x = 0; x < surface.size[0]; ++x) {
      const std::size_t voxel = index_of(surface, {x, row.y, row.z});
      for (int axis = 0; axis < 3; ++axis) sums.sums[axis][voxel] = row.sums[axis][x] / 65536.0;
      sums.lost[0][voxel] = row.lost_x;
      sums.lost[1][voxel] = row.lost_y[x];
      sums.lost[2][voxel] = row.lost_z[x];
      EXPECT_TRUE(row.any_lost || row.lost_x + row.lost_y[x] + row.lost_z[x] == 0);
    }
  });
  return sums;
}

GridSurface surface_of(const Mesh& mesh, const std::array<int, 3>& size, const Box& part) {
  return {size, mesh.vertices, mesh.triangles, part};
}

/// Of these sizes, some are longer than the layers that a task gets, and none is a multiple of a vector.
std::vector<GridSurface> surfaces() {
  const Vec3 middle(9.1, 11.2, 10.3);
  const std::array<int, 3> size{18, 22, 21};
  const Box whole{Vec3::Zero(), {18, 22, 21}}, part{{4.3, 0, 6.6}, {13, 17.7, 19.1}};
  const Mesh torus = meshes::moved(meshes::torus(6, 2, 40, 20), fixtures::random_rotation(2), middle);
  const Mesh ball = meshes::moved(meshes::sphere(2), 5 * Mat3::Identity(), middle);
  Mesh open = meshes::joined(torus, ball);
  open.triangles.erase(open.triangles.begin() + 300, open.triangles.begin() + 340);
  const Mesh large = meshes::box(Vec3(-20, 3.125, -9), Vec3(50, 12.5, 10.1));  // its sides lie on rays
  return {surface_of(meshes::joined(torus, ball), size, whole), surface_of(meshes::joined(torus, ball), size, part),
          surface_of(open, size, whole), surface_of(open, size, part), surface_of(large, size, whole)};
}

TEST(AxisSums, AreThoseOfRayAfterRay) {
  for (const GridSurface& surface : surfaces()) {
    const Sums expected = ray_by_ray(surface), found = by_layers(surface);
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < surface.voxels(); ++i) {
        ASSERT_NEAR(found.sums[axis][i], expected.sums[axis][i], 1e-3) << axis << " " << i;  // each of 16 rays is rounded twice
        ASSERT_EQ(found.lost[axis][i] > 0, expected.lost[axis][i] > 0) << axis << " " << i;
        if (surface.part.min == Vec3::Zero()) {
          ASSERT_FLOAT_EQ(found.lost[axis][i], expected.lost[axis][i] / 16);
        }
      }
    }
  }
}

TEST(AxisSums, DoNotDependOnThreadsOrOrder) {
  GridSurface surface = surfaces()[3];
  const Sums many = by_layers(surface);
  std::reverse(surface.triangles.begin(), surface.triangles.end());
  const ThreadLimit one(1);
  const Sums again = by_layers(surface);
  EXPECT_EQ(again.sums, many.sums);
  EXPECT_EQ(again.lost, many.lost);
}

}  // namespace
}  // namespace homolog
