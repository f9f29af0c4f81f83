// SPDX-License-Identifier: MIT
#include "homolog/describe/spherical_harmonics.h"

#include <cmath>
#include <numbers>

namespace homolog {
namespace {

using std::numbers::pi;

struct Node {
  double x, weight;
};

// Zeros of the Legendre polynomial P_n by Newton's method, with the weights of Gauss.
std::vector<Node> gauss_legendre(int n) {
  std::vector<Node> nodes;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(pi * (i + 0.75) / (n + 0.5)), slope = 1;
    for (int step = 0; step < 20; ++step) {
      double before = 1, now = x;
      for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * now - (k - 1) * before) / k;
        before = now;
        now = next;
      }
      slope = n * (x * now - before) / (x * x - 1);
      x -= now / slope;
    }
    nodes.push_back({x, 2 / ((1 - x * x) * slope * slope)});
  }
  return nodes;
}

// P_lm(x) sqrt((2l+1)/4pi (l-m)!/(l+m)!) for all l, m (eq. 4), by the stable recursion in l.
std::vector<double> normalised_legendre(int degree, double x) {
  std::vector<double> p(harmonics_count(degree));
  const double sine = std::sqrt(1 - x * x);
  double diagonal = std::sqrt(1 / (4 * pi));
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) diagonal *= -sine * std::sqrt((2 * m + 1) / (2.0 * m));
    p[harmonics_index(m, m)] = diagonal;
    if (m < degree) p[harmonics_index(m + 1, m)] = x * std::sqrt(2.0 * m + 3) * diagonal;
    for (int l = m + 2; l <= degree; ++l) {
      const double a = std::sqrt((4.0 * l * l - 1) / (l * l - m * m));
      const double b = std::sqrt(((l - 1.0) * (l - 1.0) - m * m) / (4 * (l - 1.0) * (l - 1.0) - 1));
      p[harmonics_index(l, m)] = a * (x * p[harmonics_index(l - 1, m)] - b * p[harmonics_index(l - 2, m)]);
    }
  }
  return p;
}

}  // namespace

int harmonics_count(int degree) { return (degree + 1) * (degree + 2) / 2; }
int harmonics_index(int l, int m) { return l * (l + 1) / 2 + m; }

SphereGrid::SphereGrid(int degree) : degree_(degree), latitudes_(degree + 4), longitudes_(2 * (degree + 4)) {
  for (const Node& node : gauss_legendre(latitudes_)) {
    for (double p : normalised_legendre(degree, node.x)) legendre_.push_back(p * node.weight * 2 * pi / longitudes_);
    const double sine = std::sqrt(1 - node.x * node.x);
    for (int j = 0; j < longitudes_; ++j) {
      const double azimuth = 2 * pi * j / longitudes_;
      directions_.emplace_back(sine * std::cos(azimuth), sine * std::sin(azimuth), node.x);
    }
  }
  for (int j = 0; j < longitudes_; ++j) {
    for (int m = 0; m <= degree; ++m) longitude_.push_back(std::polar(1.0, -2 * pi * j * m / longitudes_));
  }
}

std::vector<std::complex<double>> SphereGrid::project(const std::vector<double>& values) const {
  const int count = harmonics_count(degree_);
  std::vector<std::complex<double>> c(count), fourier(degree_ + 1);
  for (int i = 0; i < latitudes_; ++i) {
    std::fill(fourier.begin(), fourier.end(), 0);
    for (int j = 0; j < longitudes_; ++j) {
      for (int m = 0; m <= degree_; ++m) fourier[m] += values[i * longitudes_ + j] * longitude_[j * (degree_ + 1) + m];
    }
    for (int l = 0; l <= degree_; ++l) {
      for (int m = 0; m <= l; ++m) c[harmonics_index(l, m)] += legendre_[i * count + harmonics_index(l, m)] * fourier[m];
    }
  }
  return c;
}

}  // namespace homolog
