// SPDX-License-Identifier: MIT
#include "homolog/describe/descriptors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "homolog/base/parallel.h"
#include "homolog/describe/spherical_harmonics.h"
#include "homolog/shape/many_samples.h"

namespace homolog {
namespace {

constexpr int radial_samples = 3;  // per shell

// Averages of 2 x 2 x 2 voxels, so that a coarse shell sees the share of a region and not single voxels.
Interior halve(const Interior& fine) {
  Interior coarse;
  for (int a = 0; a < 3; ++a) coarse.frame.size[a] = (fine.frame.size[a] + 1) / 2;
  coarse.frame.spacing = 2 * fine.frame.spacing;
  coarse.frame.origin = fine.frame.world_from_voxel(Vec3::Constant(0.5));
  coarse.frame.axes = fine.frame.axes;
  coarse.values.assign(coarse.frame.voxels(), 0);
  const int pairs = fine.frame.size[0] / 2, odd = fine.frame.size[0] % 2;
  parallel_for(coarse.frame.size[2], [&](std::size_t layer) {
    const int first = 2 * static_cast<int>(layer);
    for (int k = first; k < std::min(first + 2, fine.frame.size[2]); ++k) {
      for (int j = 0; j < fine.frame.size[1]; ++j) {
        const float* row = &fine.at(0, j, k);
        float* sums = &coarse.at(0, j / 2, k / 2);
        for (int i = 0; i < pairs; ++i) sums[i] = sums[i] + row[2 * i] / 8 + row[2 * i + 1] / 8;
        if (odd) sums[pairs] += row[2 * pairs] / 8;
      }
    }
  });
  return coarse;
}

std::vector<Interior> halved_levels(const Interior& interior) {
  std::vector<Interior> levels;
  for (const Interior* last = &interior; *std::max_element(last->frame.size.begin(), last->frame.size.end()) > 8; last = &levels.back()) {
    levels.push_back(halve(*last));
  }
  return levels;
}

// Level whose voxels are about half as wide as the samples are apart.
const Interior& level_for(const Interior& interior, const std::vector<Interior>& halved, double sample_distance) {
  const int level = static_cast<int>(std::floor(std::log2(std::max(1.0, 0.5 * sample_distance / interior.frame.spacing))));
  return level == 0 || halved.empty() ? interior : halved[std::min<std::size_t>(level, halved.size()) - 1];
}

double shell_border(const DescriptorParams& params, double share) {
  if (params.shells == Shells::linear) return params.inner + share * (params.outer - params.inner);
  return params.inner * std::pow(params.outer / params.inner, share);
}

// A frame with z = p; the azimuth is free since only its amplitudes are used (eq. 6), which makes o_l(R) of eq. 5 unnecessary.
Mat3 frame_about(const Vec3& p) {
  Mat3 frame;
  frame.col(2) = p;
  frame.col(0) = p.unitOrthogonal();
  frame.col(1) = p.cross(frame.col(0));
  return frame;
}

void append_invariants(const std::vector<std::complex<double>>& c, const DescriptorParams& params, Descriptor& mu) {
  for (int l = 0; l <= params.degree; ++l) {
    double square = 0;
    for (int m = 0; m <= l; ++m) {
      const double part = (m > 0 ? 2 : 1) * std::norm(c[harmonics_index(l, m)]);
      square += part;
      if (params.kind == DescriptorKind::axial) mu.push_back(static_cast<float>(std::sqrt(part)));
    }
    if (params.kind == DescriptorKind::free) mu.push_back(static_cast<float>(std::sqrt(square)));
  }
}

// The sphere's directions about p, along the axes of the grid.
VectorColumns directions_about(const Vec3& p, const SphereGrid& grid, const GridFrame& frame) {
  const Mat3 turn = frame.axes.transpose() * frame_about(p);
  std::vector<Vec3> directions;
  directions.reserve(grid.directions().size());
  for (const Vec3& direction : grid.directions()) directions.push_back(turn * direction);
  return VectorColumns(directions);
}

Descriptor describe_point(const Interior& interior, const std::vector<Interior>& halved, const SalientPoint& point, const SphereGrid& grid,
                          const DescriptorParams& params) {
  const VectorColumns directions = directions_about(point.direction, grid, interior.frame);
  const double angle = std::sqrt(4 * std::numbers::pi / static_cast<double>(grid.directions().size()));
  Descriptor mu;
  std::vector<float> sums(directions.x.size());
  std::vector<double> values(grid.directions().size());
  for (int shell = 0; shell < params.shell_count; ++shell) {
    std::fill(sums.begin(), sums.end(), 0.0f);
    for (int sample_index = 0; sample_index < radial_samples; ++sample_index) {
      const double share = (shell + (sample_index + 0.5) / radial_samples) / params.shell_count;
      const double radius = point.radius * shell_border(params, share);
      const Interior& level = level_for(interior, halved, angle * radius);
      add_samples(level, level.frame.voxel_from_world(point.position), radius / level.frame.spacing, directions, sums.data());
    }
    for (std::size_t d = 0; d < values.size(); ++d) values[d] = sums[d] / radial_samples;
    append_invariants(grid.project(values), params, mu);
  }
  return mu;
}

}  // namespace

Descriptors compute_descriptors(const Interior& interior, const std::vector<SalientPoint>& points, const DescriptorParams& params) {
  const SphereGrid grid(params.degree);
  const std::vector<Interior> halved = halved_levels(interior);
  Descriptors descriptors(points.size());
  parallel_for(points.size(), [&](std::size_t i) { descriptors[i] = describe_point(interior, halved, points[i], grid, params); });
  return descriptors;
}

double descriptor_distance(const Descriptor& model, const Descriptor& data, DescriptorKind kind) {
  double sum = 0;
  for (std::size_t i = 0; i < model.size(); ++i) {
    const double difference = std::abs(static_cast<double>(model[i]) - data[i]);
    sum += kind == DescriptorKind::free ? difference : difference * difference;
  }
  return kind == DescriptorKind::free ? sum : std::sqrt(sum);
}

}  // namespace homolog
