// SPDX-License-Identifier: MIT
#include "homolog/shape/principal_axes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace homolog {
namespace {

struct Corners {
  Vec3 a, b, c;
};

template <class Visit>
void visit_triangles(const Mesh& mesh, const Vec3& middle, const Visit& visit) {
  for (const auto& [a, b, c] : mesh.triangles) {
    const Corners at{mesh.vertices[a] - middle, mesh.vertices[b] - middle, mesh.vertices[c] - middle};
    visit(at, (at.b - at.a).cross(at.c - at.a).norm() / 2);
  }
}

Vec3 centroid(const Mesh& mesh, const Vec3& about) {
  Vec3 moment = Vec3::Zero();
  double area = 0;
  visit_triangles(mesh, about, [&](const Corners& at, double own) {
    moment += own * (at.a + at.b + at.c) / 3;
    area += own;
  });
  return area > 0 ? Vec3(about + moment / area) : about;
}

Mat3 second_moments(const Mesh& mesh, const Vec3& middle) {
  Mat3 moments = Mat3::Zero();
  visit_triangles(mesh, middle, [&](const Corners& at, double area) {
    const Vec3 sum = at.a + at.b + at.c;
    moments += area / 12 * (at.a * at.a.transpose() + at.b * at.b.transpose() + at.c * at.c.transpose() + sum * sum.transpose());
  });
  return moments;
}

constexpr double alike = 1e-5;  // shares of the largest moment

// The unit vector across `axis` that is nearest to the first coordinate axis that is not along it.
Vec3 across(const Vec3& axis) {
  Eigen::Index least = 0;
  for (Eigen::Index k = 1; k < 3; ++k) {
    if (std::abs(axis[k]) < std::abs(axis[least]) - alike) least = k;
  }
  const Vec3 unit = Vec3::Unit(least);
  return (unit - axis.dot(unit) * axis).normalized();
}

// Eigenvectors, the largest value first; of equal values any would do, so that one way is chosen.
Mat3 axes_of(const Mat3& moments) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(moments);
  const Vec3 values = solver.eigenvalues().reverse();
  Mat3 axes = solver.eigenvectors().rowwise().reverse();
  const bool first = values[0] - values[1] < alike * values[0], last = values[1] - values[2] < alike * values[0];
  if (first && last) return Mat3::Identity();
  if (first) {
    axes.col(0) = across(axes.col(2));
    axes.col(1) = axes.col(2).cross(axes.col(0));
  }
  if (last) axes.col(1) = across(axes.col(0));
  return axes;
}

// Integrals of the cubes of the coordinates along the first two axes.
std::array<double, 2> third_moments(const Mesh& mesh, const Vec3& middle, const Mat3& axes) {
  std::array<double, 2> moments{};
  visit_triangles(mesh, middle, [&](const Corners& at, double area) {
    for (int k = 0; k < 2; ++k) {
      const double a = at.a.dot(axes.col(k)), b = at.b.dot(axes.col(k)), c = at.c.dot(axes.col(k));
      moments[k] += area / 10 * (a * a * a + b * b * b + c * c * c + (a + b) * a * b + (b + c) * b * c + (c + a) * c * a + a * b * c);
    }
  });
  return moments;
}

}  // namespace

Mat3 principal_axes(const Mesh& mesh) {
  if (mesh.triangles.empty()) return Mat3::Identity();
  const Vec3 middle = centroid(mesh, bounding_box(mesh).min);
  const Mat3 moments = second_moments(mesh, middle);
  const double largest = moments.cwiseAbs().maxCoeff();
  if (!(largest > 0) || !std::isfinite(largest)) return Mat3::Identity();
  Mat3 axes = axes_of(moments / largest);
  const std::array<double, 2> skew = third_moments(mesh, middle, axes);
  for (int k = 0; k < 2; ++k) {
    if (skew[k] < 0) axes.col(k) *= -1;
  }
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

Mesh turned(Mesh mesh, const Mat3& rotation) {
  for (Vec3& vertex : mesh.vertices) vertex = rotation * vertex;
  return mesh;
}

}  // namespace homolog
