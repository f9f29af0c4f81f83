// SPDX-License-Identifier: MIT
#include "other_forms.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "change_mesh.h"
#include "homolog/shape/cloud_surface.h"
#include "homolog/shape/label_surface.h"
#include "homolog/shape/surface_nets.h"
#include "homolog/shape/voxelize.h"
#include "random.h"

namespace homolog::bench {
namespace {

/// The coarsest grid that leaves this share of the triangles.
Mesh coarsened(const Mesh& mesh, double share) {
  const double wanted = share * static_cast<double>(mesh.triangles.size());
  int low = 2, high = 1024;
  while (low < high) {
    const int cells = (low + high) / 2;
    if (static_cast<double>(clustered(mesh, cells).triangles.size()) < wanted) {
      low = cells + 1;
    } else {
      high = cells;
    }
  }
  return clustered(mesh, low);
}

Mesh soup(const Mesh& mesh, double missing, double turned) {
  Random random(1, "soup");
  Mesh result;
  for (const auto& triangle : mesh.triangles) {
    const bool left_out = random.unit() < missing, is_turned = random.unit() < turned;
    if (left_out) continue;
    const auto n = static_cast<std::uint32_t>(result.vertices.size());
    for (const std::uint32_t corner : triangle) result.vertices.push_back(mesh.vertices[corner]);
    result.triangles.push_back({n, is_turned ? n + 2 : n + 1, is_turned ? n + 1 : n + 2});
  }
  return result;
}

/// A soup without holes whose corners are moved by normal noise (in shares of the diagonal), as rounding leaves them.
Mesh moved_seams(const Mesh& mesh, double noise) {
  Random random(1, "seams");
  const double size = noise * bounding_box(mesh).diagonal();
  Mesh result = soup(mesh, 0, 0.3);
  for (Vec3& vertex : result.vertices) vertex += size * Vec3(random.normal(), random.normal(), random.normal());
  return result;
}

/// As a segmentation would have it: a voxel belongs to the label when more than half of it is inside.
Mesh labelled(const Mesh& mesh, int resolution) {
  const Interior interior = voxelize(mesh, resolution).interior;
  RawVolume volume;
  for (int axis = 0; axis < 3; ++axis) volume.size[axis] = interior.frame.size[axis];
  volume.world_from_voxel.topLeftCorner<3, 3>() *= interior.frame.spacing;
  volume.world_from_voxel.topRightCorner<3, 1>() = interior.frame.origin;
  for (const float value : interior.values) volume.bytes += value > 0.5f ? '\1' : '\0';
  return label_surface(volume, {}, "the label volume");
}

/// Points drawn evenly from the surface, each moved by normal noise (in shares of the diagonal), with the normals of their triangles.
PointCloud sampled(const Mesh& mesh, std::size_t count, double noise) {
  Random random(1, "points");
  std::vector<double> sums{0};
  for (const auto& [a, b, c] : mesh.triangles) {
    sums.push_back(sums.back() + (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm());
  }
  const double size = noise * bounding_box(mesh).diagonal();
  PointCloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    const auto above = std::upper_bound(sums.begin(), sums.end(), random.unit() * sums.back());
    const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(above - sums.begin() - 1)];
    const double root = std::sqrt(random.unit()), share = random.unit();
    const Vec3 along = mesh.vertices[b] - mesh.vertices[a], across = mesh.vertices[c] - mesh.vertices[a];
    cloud.points.push_back(mesh.vertices[a] + root * ((1 - share) * along + share * across) +
                           size * Vec3(random.normal(), random.normal(), random.normal()));
    cloud.normals.push_back(along.cross(across).normalized());
  }
  return cloud;
}

}  // namespace

Mesh remeshed(const Mesh& mesh) {
  const Interior interior = voxelize(mesh, 256).interior;
  const auto& frame = interior.frame;
  Mesh result = surface_nets({frame.size,
                              [&](int z, std::vector<float>& slice) {
                                const auto first = interior.values.begin() + static_cast<std::ptrdiff_t>(frame.index(0, 0, z));
                                std::copy(first, first + static_cast<std::ptrdiff_t>(slice.size()), slice.begin());
                              }},
                             0);
  for (Vec3& vertex : result.vertices) vertex = frame.world_from_voxel(vertex);
  return result;
}

std::vector<NamedMesh> other_forms(const Mesh& mesh) {
  return {{"remeshed", remeshed(mesh)},
          {"5 % of the triangles", coarsened(mesh, 0.05)},
          {"soup", soup(mesh, 0.1, 0.3)},
          {"seams moved", moved_seams(mesh, 1e-9)},
          {"label volume, 128", labelled(mesh, 128)},
          {"label volume, 256", labelled(mesh, 256)},
          {"5 000 points", cloud_surface(sampled(mesh, 5000, 0), "the point cloud")},
          {"50 000 points", cloud_surface(sampled(mesh, 50000, 0), "the point cloud")},
          {"50 000 points, noise", cloud_surface(sampled(mesh, 50000, 0.001), "the point cloud")},
          {"500 000 points", cloud_surface(sampled(mesh, 500000, 0), "the point cloud")}};
}

}  // namespace homolog::bench
