// SPDX-License-Identifier: MIT
#include "homolog/salient/response_at.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "homolog/salient/scale_space.h"

namespace homolog {
namespace {

constexpr double reach = 4;             // standard deviations
constexpr double samples_across = 2.5;  // the narrower standard deviation, at least

// Both Gaussians along one axis, at every n-th voxel near a place. In single precision: the last bit of exp differs between processors.
struct Axis {
  std::vector<int> voxels;
  std::vector<float> narrow, wide;
};

Axis axis_about(double x, int size, int step, double narrow, double wide) {
  Axis axis;
  const auto weight = [&](double d, double sigma) {
    return std::exp(-0.5 * d * d / (sigma * sigma)) / (sigma * std::sqrt(2 * std::numbers::pi));
  };
  const int first = std::max(0, static_cast<int>(std::ceil((x - reach * wide) / step)) * step);
  for (int v = first; v < size && v <= x + reach * wide; v += step) {
    axis.voxels.push_back(v);
    axis.narrow.push_back(static_cast<float>(step * weight(v - x, narrow)));
    axis.wide.push_back(static_cast<float>(step * weight(v - x, wide)));
  }
  return axis;
}

}  // namespace

double response_at(const Interior& interior, const Vec3& position, double radius, const SalientParams& params) {
  const double k = std::pow(2, 1.0 / params.levels_per_octave);
  const double sigma = radius / radius_factor(k) / std::sqrt(k) / interior.frame.spacing;
  const auto remaining = [](double total) { return std::sqrt(std::max(0.1, total * total - coverage_variance)); };
  const double narrow = remaining(sigma), wide = remaining(k * sigma);
  const int step = std::max(1, static_cast<int>(narrow / samples_across));
  const Vec3 x = interior.frame.voxel_from_world(position);
  std::array<Axis, 3> axes;
  for (int a = 0; a < 3; ++a) axes[a] = axis_about(x[a], interior.frame.size[a], step, narrow, wide);
  double difference = 0;
  for (std::size_t n = 0; n < axes[2].voxels.size(); ++n) {
    for (std::size_t m = 0; m < axes[1].voxels.size(); ++m) {
      double row_narrow = 0, row_wide = 0;
      for (std::size_t l = 0; l < axes[0].voxels.size(); ++l) {
        const double chi = interior.at(axes[0].voxels[l], axes[1].voxels[m], axes[2].voxels[n]);
        row_narrow += chi * axes[0].narrow[l];
        row_wide += chi * axes[0].wide[l];
      }
      difference += row_wide * axes[1].wide[m] * axes[2].wide[n] - row_narrow * axes[1].narrow[m] * axes[2].narrow[n];
    }
  }
  return difference / std::log(k) / ball_response(k);
}

}  // namespace homolog
