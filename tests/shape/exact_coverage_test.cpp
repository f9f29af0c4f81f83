// SPDX-License-Identifier: MIT
// Exact shares against the formula of a volume, and against rays.
#include "homolog/shape/exact_coverage.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "fixtures/solids.h"
#include "homolog/base/parallel.h"
#include "homolog/shape/inside.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

/// A mesh on a grid of `size` voxels an edge, with one voxel around, of which `part`, in shares, counts.
GridSurface on_grid(const Mesh& mesh, int size, const Box& part = {Vec3::Zero(), Vec3::Ones()}) {
  const Box box = bounding_box(mesh);
  const double spacing = (box.max - box.min).maxCoeff() / (size - 2);
  GridSurface surface{{size, size, size}, {}, mesh.triangles, {size * part.min, size * part.max}};
  for (const Vec3& vertex : mesh.vertices) {
    surface.vertices.emplace_back((vertex - (box.min + box.max) / 2) / spacing + Vec3::Constant(size / 2.0));
  }
  return surface;
}

double volume_of(const GridSurface& surface) {
  double volume = 0;
  for (const auto& [a, b, c] : surface.triangles) volume += surface.vertices[a].dot(surface.vertices[b].cross(surface.vertices[c])) / 6;
  return volume;
}

double sum_of(const std::vector<float>& coverage) { return std::accumulate(coverage.begin(), coverage.end(), 0.0); }

std::vector<Mesh> solids() {
  return {meshes::moved(meshes::sphere(4), fixtures::random_rotation(1)),
          meshes::moved(meshes::torus(1, 0.1, 60, 20), fixtures::random_rotation(2)),
          meshes::moved(meshes::box({0, 0, 0}, {3, 2, 0.1}), fixtures::random_rotation(3)), meshes::box({0, 0, 0}, {3, 2, 0.1}),
          meshes::moved(fixtures::mesh_of(fixtures::hand(), 40), fixtures::random_rotation(4))};
}

TEST(ExactCoverage, AddsUpToTheVolume) {
  for (const Mesh& mesh : solids()) {
    const GridSurface surface = on_grid(mesh, 40);
    EXPECT_NEAR(sum_of(exact_coverage(surface)) / volume_of(surface), 1, 1e-5);
  }
}

TEST(ExactCoverage, IsWhatRaysAreNearTo) {
  for (const Mesh& mesh : solids()) {
    for (const Box& part : {Box{Vec3::Zero(), Vec3::Ones()}, Box{{0.3, 0.21, 0.13}, {0.91, 0.8, 0.55}}}) {
      const GridSurface surface = on_grid(mesh, 40, part);
      const std::vector<float> exact = exact_coverage(surface), rays = coverage_by_rays(surface);
      double square = 0, skin = 0;  // voxels that are inside in part
      for (std::size_t i = 0; i < exact.size(); ++i) {
        EXPECT_NEAR(exact[i], rays[i], 0.13);
        if (rays[i] == 0 || rays[i] == 1) EXPECT_NEAR(exact[i], rays[i], 0.03);
        square += std::pow(exact[i] - rays[i], 2);
        skin += exact[i] > 0 && exact[i] < 1 ? 1 : 0;
      }
      EXPECT_GT(skin, 100);
      EXPECT_LT(std::sqrt(square / skin), 0.08);
    }
  }
}

using Face = std::vector<Vec3>;

// What of a convex solid, given by its faces, lies where normal . x <= offset. By Sutherland and Hodgman's clipping, and a lid on the cut.
std::vector<Face> clipped(const std::vector<Face>& faces, const Vec3& normal, double offset) {
  std::vector<Face> kept;
  Face lid;
  for (const Face& face : faces) {
    Face part;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vec3 &a = face[i], &b = face[(i + 1) % face.size()];
      const double height_a = normal.dot(a) - offset, height_b = normal.dot(b) - offset;
      if (height_a <= 0) part.push_back(a);
      if ((height_a <= 0) == (height_b <= 0)) continue;
      part.push_back(a + height_a / (height_a - height_b) * (b - a));
      lid.push_back(part.back());
    }
    if (part.size() > 2) kept.push_back(part);
  }
  if (lid.size() < 3) return kept;
  const Vec3 middle = std::accumulate(lid.begin(), lid.end(), Vec3(Vec3::Zero())) / static_cast<double>(lid.size());
  const Vec3 u = normal.unitOrthogonal(), v = normal.normalized().cross(u);
  const auto turn = [&](const Vec3& x) { return std::atan2(v.dot(x - middle), u.dot(x - middle)); };
  std::sort(lid.begin(), lid.end(), [&](const Vec3& a, const Vec3& b) { return turn(a) < turn(b); });
  kept.push_back(lid);
  return kept;
}

double volume_of(const std::vector<Face>& faces) {
  double volume = 0;
  for (const Face& face : faces) {
    for (std::size_t i = 2; i < face.size(); ++i) volume += face[0].dot(face[i - 1].cross(face[i])) / 6;
  }
  return volume;
}

std::vector<Face> voxel_faces(const Vec3& low) {
  const Mesh box = meshes::box(low, low + Vec3::Ones());
  std::vector<Face> faces;
  for (const auto& [a, b, c] : box.triangles) faces.push_back({box.vertices[a], box.vertices[b], box.vertices[c]});
  return faces;
}

TEST(ExactCoverage, OfATetrahedronIsWhatItsPlanesLeaveOfEveryVoxel) {
  const Mesh tetrahedron{{{-1, -1, -1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
  for (const int seed : {1, 2, 3}) {
    const GridSurface surface = on_grid(meshes::moved(tetrahedron, fixtures::random_rotation(seed)), 9);
    ASSERT_GT(volume_of(surface), 0);
    const std::vector<float> coverage = exact_coverage(surface);
    for (int voxel = 0; voxel < 9 * 9 * 9; ++voxel) {
      std::vector<Face> faces = voxel_faces(Vec3(voxel % 9, voxel / 9 % 9, voxel / 81));
      for (const auto& [a, b, c] : surface.triangles) {
        const Vec3 normal = (surface.vertices[b] - surface.vertices[a]).cross(surface.vertices[c] - surface.vertices[a]);
        faces = clipped(faces, normal, normal.dot(surface.vertices[a]));
      }
      EXPECT_NEAR(coverage[voxel], volume_of(faces), 2e-6) << voxel;
    }
  }
}

TEST(ExactCoverage, OfABoxIsItsSides) {  // corners a quarter, a half and a fifth of a voxel in
  GridSurface surface{{6, 6, 6}, {}, meshes::box({1.25, 1.5, 1.8}, {4, 4.5, 4.9}).triangles, {Vec3::Zero(), Vec3::Constant(6)}};
  surface.vertices = meshes::box({1.25, 1.5, 1.8}, {4, 4.5, 4.9}).vertices;
  const std::vector<float> coverage = exact_coverage(surface);
  const auto at = [&](int x, int y, int z) { return coverage[(z * 6 + y) * 6 + x]; };
  EXPECT_NEAR(at(1, 1, 1), 0.75 * 0.5 * 0.2, 1e-6);
  EXPECT_NEAR(at(3, 4, 4), 0.5 * 0.9, 1e-6);
  EXPECT_EQ(at(2, 2, 2), 1);
  EXPECT_EQ(at(4, 2, 2), 0);
}

TEST(ExactCoverage, OfOverlappingShellsIsNotTold) {
  const Mesh one = meshes::sphere(3), other = meshes::moved(one, Mat3::Identity(), {0.7, 0, 0});
  EXPECT_TRUE(exact_coverage(on_grid(meshes::joined(one, other), 30)).empty());
  const GridSurface apart = on_grid(meshes::joined(one, meshes::moved(one, Mat3::Identity(), {2.5, 0, 0})), 30);
  EXPECT_NEAR(sum_of(exact_coverage(apart)) / volume_of(apart), 1, 1e-5);
}

TEST(ExactCoverage, DoesNotDependOnThreads) {
  const GridSurface surface = on_grid(solids().back(), 70);
  const std::vector<float> many = exact_coverage(surface);
  const ThreadLimit limit(1);
  EXPECT_EQ(exact_coverage(surface), many);
}

}  // namespace
}  // namespace homolog
