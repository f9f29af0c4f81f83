// SPDX-License-Identifier: MIT
#include "homolog/match/elastic_skin.h"

#include <gtest/gtest.h>

#include "fixtures/solids.h"
#include "homolog/shape/weld.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

const Mesh sphere = meshes::sphere(3);
const fixtures::Similarity turn{fixtures::random_rotation(5), 3, {10, -20, 5}};

std::vector<Vec3> turned(const std::vector<Vec3>& vertices) {
  std::vector<Vec3> result;
  for (const Vec3& vertex : vertices) result.push_back(turn(vertex));
  return result;
}

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

VertexPull none(const Mesh& mesh) {
  return {std::vector<Vec3>(mesh.vertices.size(), Vec3::Zero()), std::vector<double>(mesh.vertices.size(), 0)};
}

TEST(ElasticSkin, StaysWhenNothingPulls) {
  const std::vector<Vec3> positions = turned(sphere.vertices);
  EXPECT_LT(farthest(ElasticSkin(sphere, 3, Chirality::proper).drawn(positions, none(sphere), 1), positions), 1e-3);
}

TEST(ElasticSkin, FollowsAFewVerticesAsAWhole) {
  const std::vector<Vec3> positions = turned(sphere.vertices);
  VertexPull pull = none(sphere);
  const Vec3 shift(0.3, 0, 0.1);
  for (std::size_t i = 0; i < positions.size(); i += 5) {
    pull.targets[i] = positions[i] + shift;
    pull.weights[i] = 1;
  }
  const auto drawn = ElasticSkin(sphere, 3, Chirality::proper).drawn(positions, pull, 3);
  for (std::size_t i = 0; i < drawn.size(); ++i) EXPECT_LT((drawn[i] - positions[i] - shift).norm(), 0.01);
}

TEST(ElasticSkin, SmoothsWhatNoiseAsksFor) {
  const std::vector<Vec3> positions = turned(sphere.vertices);
  VertexPull pull{positions, std::vector<double>(positions.size(), 1)};
  for (std::size_t i = 0; i < positions.size(); ++i) pull.targets[i] += 0.2 * (i % 2 == 0 ? 1 : -1) * Vec3::UnitX();
  const auto drawn = ElasticSkin(sphere, 3, Chirality::proper).drawn(positions, pull, 2);
  EXPECT_LT(farthest(drawn, positions), 0.1);
}

TEST(ElasticSkin, MayBeAMirrorImage) {
  std::vector<Vec3> positions;
  for (const Vec3& vertex : sphere.vertices) positions.push_back(3 * (fixtures::mirror_x() * vertex));
  EXPECT_LT(farthest(ElasticSkin(sphere, 3, Chirality::mirrored).drawn(positions, none(sphere), 1), positions), 1e-3);
}

TEST(ElasticSkin, TakesVerticesWithoutTrianglesAndTwins) {
  Mesh mesh = sphere;
  mesh.vertices.push_back({7, 7, 7});              // of no triangle
  mesh.vertices.push_back(mesh.vertices.front());  // a seam
  VertexPull pull = none(mesh);
  const std::size_t lone = mesh.vertices.size() - 2, twin = lone + 1;
  pull.targets[lone] = {8, 7, 7};
  pull.weights[lone] = 1;
  const auto drawn = ElasticSkin(mesh, 1, Chirality::proper).drawn(mesh.vertices, pull, 1);
  EXPECT_NEAR((drawn[lone] - Vec3(8, 7, 7)).norm(), 0, 1e-3);
  EXPECT_EQ(drawn[twin], drawn[0]);
}

/// The integral of grad phi_i . grad phi_j over the surface, phi the piecewise linear functions of the vertices.
Eigen::MatrixXd gradient_products(const Mesh& mesh) {
  const auto count = static_cast<Eigen::Index>(mesh.vertices.size());
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(count, count);
  for (const auto& triangle : mesh.triangles) {
    const auto corner = [&](int k) { return mesh.vertices[triangle[k % 3]]; };
    const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));  // as long as twice the area
    for (int k = 0; k < 3; ++k) {
      for (int l = 0; l < 3; ++l) {
        const Vec3 a = normal.cross(corner(k + 2) - corner(k + 1)), b = normal.cross(corner(l + 2) - corner(l + 1));
        products(triangle[k], triangle[l]) += a.dot(b) / std::pow(normal.norm(), 4) * normal.norm() / 2;
      }
    }
  }
  return products;
}

struct Solved {
  Eigen::MatrixXd system;
  Eigen::MatrixX3d places;  ///< at which no force is left
};

/// The least of the sum in elastic_skin.h, and of a ten-thousandth of the surface times how far each vertex goes, by a full matrix.
Solved solved(const Mesh& mesh, double scale, Chirality chirality, const std::vector<Vec3>& positions, const VertexPull& pull,
              double length) {
  const Eigen::MatrixXd stiffness = gradient_products(mesh);
  const auto count = static_cast<Eigen::Index>(mesh.vertices.size());
  std::vector<Mat3> local(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    Mat3 covariance = Mat3::Zero();
    double square = 0;
    for (Eigen::Index j = 0; j < count; ++j) {
      const Vec3 rest = mesh.vertices[i] - mesh.vertices[j];
      covariance -= stiffness(i, j) * (positions[i] - positions[j]) * rest.transpose();
      square -= stiffness(i, j) * rest.squaredNorm();
    }
    const Turn turn = nearest_turn(covariance, chirality);
    local[i] = std::sqrt(turn.trace / square * scale) * turn.rotation;
  }
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(count);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 normal = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
    for (const auto corner : {a, b, c}) areas[corner] += scale * scale * normal.norm() / 6;
  }
  Eigen::MatrixXd system = length * length * stiffness;
  Eigen::MatrixX3d right(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    system(i, i) += (pull.weights[i] + 1e-4) * areas[i];
    Vec3 sum = areas[i] * (pull.weights[i] * pull.targets[i] + 1e-4 * positions[i]);
    for (Eigen::Index j = 0; j < count; ++j) {
      sum -= length * length * stiffness(i, j) * (local[i] + local[j]) / 2 * (mesh.vertices[i] - mesh.vertices[j]);
    }
    right.row(i) = sum.transpose();
  }
  return {system, system.ldlt().solve(right)};
}

Eigen::MatrixX3d rows_of(const std::vector<Vec3>& places) {
  Eigen::MatrixX3d rows(places.size(), 3);
  for (std::size_t i = 0; i < places.size(); ++i) rows.row(static_cast<Eigen::Index>(i)) = places[i].transpose();
  return rows;
}

TEST(ElasticSkin, GoesWhereAFullMatrixSays) {
  const Mesh small = meshes::moved(weld(meshes::split(meshes::icosahedron(), 1)), Vec3(1, 1.1, 0.95).asDiagonal());  // all angles are acute
  for (const auto chirality : {Chirality::proper, Chirality::mirrored}) {
    std::vector<Vec3> positions;
    for (const Vec3& v : small.vertices)
      positions.push_back(turn((chirality == Chirality::proper ? 1 : -1) * v + Vec3(0.2 * v.z() * v.z(), 0, 0)));
    VertexPull pull = none(small);
    for (std::size_t i = 0; i < positions.size(); i += 3) {
      pull.targets[i] = positions[i] + Vec3(0.3, 0.1 * positions[i].y(), -0.2);
      pull.weights[i] = 0.5 + 0.1 * static_cast<double>(i % 5);
    }
    for (const double length : {0.2, 1.0, 5.0}) {
      const auto drawn = ElasticSkin(small, 3, chirality).drawn(positions, pull, length);
      const auto [system, places] = solved(small, 3, chirality, positions, pull, length);
      const Eigen::MatrixX3d before = system * (places - rows_of(positions)), left = system * (places - rows_of(drawn));
      for (int axis = 0; axis < 3; ++axis) EXPECT_LT(left.col(axis).norm(), 1.1e-3 * before.col(axis).norm()) << length;
    }
  }
}

}  // namespace
}  // namespace homolog
