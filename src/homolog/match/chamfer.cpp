// SPDX-License-Identifier: MIT
// Sec. 6.2.3, eq. 9.
#include "homolog/match/chamfer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "homolog/base/parallel.h"

namespace homolog {
namespace {

using Voxel = std::array<int, 3>;

template <class Visit>
void for_each_voxel(const Voxel& begin, const Voxel& end, const Visit& visit) {
  for (int k = begin[2]; k < end[2]; ++k) {
    for (int j = begin[1]; j < end[1]; ++j) {
      for (int i = begin[0]; i < end[0]; ++i) visit(i, j, k);
    }
  }
}

InteriorSample sample_cell(const Interior& interior, const Voxel& begin, const Voxel& end) {
  const Vec3 middle = 0.5 * Vec3(begin[0] + end[0] - 1, begin[1] + end[1] - 1, begin[2] + end[2] - 1);
  InteriorSample sample;
  float fullest = 0;
  double nearest = 0;
  for_each_voxel(begin, end, [&](int i, int j, int k) {
    const float coverage = interior.at(i, j, k);
    if (coverage <= 0) return;
    sample.weight += coverage;
    const double way = (Vec3(i, j, k) - middle).squaredNorm();
    if (coverage < fullest || (coverage == fullest && way >= nearest)) return;
    fullest = coverage;
    nearest = way;
    sample.position = interior.frame.world_from_voxel(Vec3(i, j, k));
  });
  return sample;
}

}  // namespace

std::vector<InteriorSample> sample_interior(const Interior& interior, int cells) {
  const Voxel& size = interior.frame.size;
  const int stride = std::max(1, (*std::max_element(size.begin(), size.end()) + cells - 1) / cells);
  const auto cells_along = [&](int axis) { return (size[axis] + stride - 1) / stride; };
  std::vector<std::vector<InteriorSample>> layers(static_cast<std::size_t>(cells_along(2)));
  parallel_for(layers.size(), [&](std::size_t k) {
    const int z = static_cast<int>(k);
    for_each_voxel({0, 0, z}, {cells_along(0), cells_along(1), z + 1}, [&](int i, int j, int) {
      const Voxel begin{i * stride, j * stride, z * stride};
      const Voxel end{std::min(size[0], begin[0] + stride), std::min(size[1], begin[1] + stride), std::min(size[2], begin[2] + stride)};
      const InteriorSample sample = sample_cell(interior, begin, end);
      if (sample.weight > 0) layers[k].push_back(sample);
    });
  });
  std::vector<InteriorSample> samples;
  for (const auto& layer : layers) samples.insert(samples.end(), layer.begin(), layer.end());
  return samples;
}

std::vector<InteriorSample> covered_samples(const std::vector<InteriorSample>& samples, const std::vector<SalientPoint>& points,
                                            double reach) {
  std::vector<InteriorSample> covered;
  for (const InteriorSample& sample : samples) {
    const auto near = [&](const SalientPoint& point) { return (sample.position - point.position).norm() <= reach * point.radius; };
    if (std::any_of(points.begin(), points.end(), near)) covered.push_back(sample);
  }
  return covered;
}

double distance_at(const InsideTree& data, const Vec3& world) {
  if (!world.allFinite()) return std::numeric_limits<double>::infinity();
  const GridFrame& frame = data.frame();
  const Vec3 v = frame.voxel_from_world(world);
  const Vec3 clamped = v.cwiseMax(0.0).cwiseMin(Vec3(frame.size[0] - 1, frame.size[1] - 1, frame.size[2] - 1));
  const Vec3 low = clamped.array().floor(), share = clamped - low;
  double distance = 0;
  for_each_voxel({0, 0, 0}, {2, 2, 2}, [&](int i, int j, int k) {
    const double weight = (i ? share[0] : 1 - share[0]) * (j ? share[1] : 1 - share[1]) * (k ? share[2] : 1 - share[2]);
    if (weight == 0) return;  // beyond the last voxel, too
    distance += weight * data.distance(static_cast<int>(low[0]) + i, static_cast<int>(low[1]) + j, static_cast<int>(low[2]) + k);
  });
  return distance + frame.spacing * (v - clamped).norm();
}

// eq. 9: inf |f(x) - x'| = DT(O')(f(x)).
double chamfer_distance(const std::vector<InteriorSample>& model, const std::function<Vec3(const Vec3&)>& data_from_model,
                        const InsideTree& data, double data_diagonal) {
  double sum = 0, weight = 0;
  for (const InteriorSample& sample : model) {
    sum += sample.weight * distance_at(data, data_from_model(sample.position));
    weight += sample.weight;
  }
  return weight > 0 ? sum / weight / data_diagonal : std::numeric_limits<double>::infinity();
}

}  // namespace homolog
