// SPDX-License-Identifier: MIT
// Sec. 5.1: the Y_lm are orthonormal, and rotations do not change the norm of a degree.
#include "homolog/describe/spherical_harmonics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fixtures/solids.h"

namespace homolog {
namespace {

using Complex = std::complex<double>;
constexpr int degree = 8;

// Eq. 4 by the standard library.
Complex Y(int l, int m, const Vec3& d) {
  const double colatitude = std::acos(std::clamp(d.z(), -1.0, 1.0));
  return std::sph_legendre(l, m, colatitude) * std::polar(1.0, m * std::atan2(d.y(), d.x()));
}

std::vector<Complex> project(const SphereGrid& grid, const std::function<double(const Vec3&)>& f) {
  std::vector<double> values;
  for (const Vec3& d : grid.directions()) values.push_back(f(d));
  return grid.project(values);
}

// A polynomial of degree 8 without any symmetry.
double bumpy(const Vec3& d) { return std::pow(d.x() + 0.3 * d.z(), 8) + 2 * d.x() * d.y() * d.z() - d.y() + 0.7 * std::pow(d.z(), 5); }

double norm_of_degree(const std::vector<Complex>& c, int l) {
  double square = 0;
  for (int m = 0; m <= l; ++m) square += (m > 0 ? 2 : 1) * std::norm(c[harmonics_index(l, m)]);  // m < 0 repeats m > 0
  return std::sqrt(square);
}

TEST(SphericalHarmonics, PlacesOfCoefficientsAreDenseAndInOrder) {
  int next = 0;
  for (int l = 0; l <= degree; ++l) {
    for (int m = 0; m <= l; ++m) EXPECT_EQ(harmonics_index(l, m), next++);
    EXPECT_EQ(harmonics_count(l), next);
  }
}

TEST(SphericalHarmonics, DirectionsAreUnitVectorsThatBalance) {
  Vec3 sum = Vec3::Zero();
  const SphereGrid grid(degree);
  for (const Vec3& d : grid.directions()) {
    EXPECT_NEAR(d.norm(), 1, 1e-14);
    sum += d;
  }
  EXPECT_LT(sum.norm(), 1e-12);
}

TEST(Sec51, HarmonicsAreOrthonormal) {
  const SphereGrid grid(degree);
  for (int l = 0; l <= degree; ++l) {
    for (int m = 0; m <= l; ++m) {
      const auto real = project(grid, [&](const Vec3& d) { return Y(l, m, d).real(); });
      const auto imaginary = project(grid, [&](const Vec3& d) { return Y(l, m, d).imag(); });
      for (int n = 0; n < harmonics_count(degree); ++n) {
        const Complex c = real[n] + Complex(0, 1) * imaginary[n];  // projecting is linear
        EXPECT_LT(std::abs(c - (n == harmonics_index(l, m) ? 1.0 : 0.0)), 1e-12) << l << ' ' << m << " at " << n;
      }
    }
  }
}

TEST(Sec51, CoefficientsGiveTheFunctionBack) {
  const SphereGrid grid(degree);
  const auto c = project(grid, bumpy);
  for (int n = 0; n < 20; ++n) {
    const Vec3 d = fixtures::random_rotation(n) * Vec3::UnitZ();
    double sum = 0;
    for (int l = 0; l <= degree; ++l) {
      for (int m = 0; m <= l; ++m) sum += (m > 0 ? 2 : 1) * (c[harmonics_index(l, m)] * Y(l, m, d)).real();
    }
    EXPECT_NEAR(sum, bumpy(d), 1e-11);
  }
}

TEST(Sec51, NormOfADegreeIsInvariantToRotation) {
  const SphereGrid grid(degree);
  const auto c = project(grid, bumpy);
  for (int n = 0; n < 10; ++n) {
    const Mat3 rotation = fixtures::random_rotation(n);
    const auto turned = project(grid, [&](const Vec3& d) { return bumpy(rotation.transpose() * d); });
    for (int l = 0; l <= degree; ++l) EXPECT_NEAR(norm_of_degree(turned, l), norm_of_degree(c, l), 1e-12) << l;
  }
}

TEST(Sec51, AmplitudesAreInvariantToTurnsAboutTheAxis) {
  const SphereGrid grid(degree);
  const auto c = project(grid, bumpy);
  const Mat3 turn = Eigen::AngleAxisd(0.77, Vec3::UnitZ()).toRotationMatrix();
  const auto turned = project(grid, [&](const Vec3& d) { return bumpy(turn.transpose() * d); });
  for (int n = 0; n < harmonics_count(degree); ++n) EXPECT_NEAR(std::abs(turned[n]), std::abs(c[n]), 1e-12);  // eq. 6
}

}  // namespace
}  // namespace homolog
