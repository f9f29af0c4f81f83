// SPDX-License-Identifier: MIT
// Sec. 4.2, 4.3: octaves of incrementally blurred coverage, each with its own margin of zeros, so that nothing is lost at the border.
#include "homolog/salient/scale_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "homolog/base/parallel.h"
#include "homolog/salient/gaussian_blur.h"

namespace homolog {
namespace {

// A voxel of coverage has already been averaged over a box, whose variance is 1/12 voxel^2.
constexpr double kCoverageVariance = 1.0 / 12;

// Mass of a unit 3D Gaussian within radius t.
double mass_within(double t) { return std::erf(t / std::sqrt(2)) - std::sqrt(2 / M_PI) * t * std::exp(-t * t / 2); }

struct VoxelBox {
  std::array<int, 3> low, high;  // inclusive
};

// The smallest box of all nonempty voxels.
VoxelBox content_of(const Interior& interior) {
  const auto& size = interior.frame.size;
  VoxelBox box{size, {-1, -1, -1}};
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      const float* row = interior.values.data() + interior.frame.index(0, j, k);
      int first = 0, last = size[0] - 1;
      while (first <= last && row[first] == 0) ++first;
      while (last > first && row[last] == 0) --last;
      if (first > last) continue;
      box.low = {std::min(box.low[0], first), std::min(box.low[1], j), std::min(box.low[2], k)};
      box.high = {std::max(box.high[0], last), std::max(box.high[1], j), std::max(box.high[2], k)};
    }
  }
  return box;
}

// Every step-th voxel of a box, with `margin` zeros around it; what the source knows beyond the box is kept within the margin.
Volume<float> resampled(const Volume<float>& source, const VoxelBox& box, int step, int margin) {
  Volume<float> result;
  GridFrame& frame = result.frame;
  std::array<int, 3> first{};
  for (int axis = 0; axis < 3; ++axis) {
    frame.size[axis] = (box.high[axis] - box.low[axis] + step - 1) / step + 1 + 2 * margin;
    first[axis] = box.low[axis] - step * margin;
  }
  frame.spacing = step * source.frame.spacing;
  frame.origin = source.frame.world_from_voxel(Vec3(first[0], first[1], first[2]));
  std::array<std::array<int, 2>, 3> known{};  // range of result voxels that the source covers
  for (int axis = 0; axis < 3; ++axis) {
    const int below = std::max(0, -first[axis]), last = source.frame.size[axis] - 1 - first[axis];
    known[axis] = {(below + step - 1) / step, std::min(frame.size[axis], last / step + 1)};
  }
  result.values.assign(frame.voxels(), 0);
  parallel_for(static_cast<std::size_t>(known[2][1] - known[2][0]), [&](std::size_t slice) {
    const int k = known[2][0] + static_cast<int>(slice);
    for (int j = known[1][0]; j < known[1][1]; ++j) {
      const float* row = source.values.data() + source.frame.index(0, first[1] + step * j, first[2] + step * k);
      for (int i = known[0][0]; i < known[0][1]; ++i) result.at(i, j, k) = row[first[0] + step * i];
    }
  });
  return result;
}

// fine becomes factor * (fine - coarse), Sec. 4.3 with the divisor ln k instead of k.
void subtract(const Volume<float>& coarse, double factor, Volume<float>& fine) {
  const std::size_t slice = static_cast<std::size_t>(fine.frame.size[0]) * fine.frame.size[1];
  parallel_for(static_cast<std::size_t>(fine.frame.size[2]), [&](std::size_t k) {
    const auto f = static_cast<float>(factor);
    for (std::size_t v = k * slice; v < (k + 1) * slice; ++v) fine.values[v] = f * (fine.values[v] - coarse.values[v]);
  });
}

}  // namespace

double ball_level(double sigma, double k) {
  const double t = std::sqrt(k) / sigma;  // r / s, the lower of the two blurs
  return (mass_within(t / k) - mass_within(t)) / std::log(k);
}

double radius_factor(double k) { return std::sqrt(3 * std::log(k) / std::sinh(std::log(k))); }

double ball_response(double k) { return ball_level(1 / radius_factor(k), k); }

void for_each_octave(const Interior& interior, const SalientParams& params, const std::function<void(const Octave&)>& visit) {
  const int levels = params.levels_per_octave;
  const double k = std::pow(2, 1.0 / levels), sigma0 = params.sigma0;
  const int margin = static_cast<int>(std::ceil(5 * sigma0));  // 2.5 blurs of the level that goes on to the next octave
  VoxelBox box = content_of(interior);
  if (box.high[0] < 0) return;
  const Vec3 extent(box.high[0] - box.low[0] + 1, box.high[1] - box.low[1] + 1, box.high[2] - box.low[2] + 1);
  const double largest_sigma = interior.frame.spacing * extent.norm() / 2 / radius_factor(k);

  Volume<float> gaussian = resampled(interior, box, 1, margin);
  gaussian = gaussian_blur(gaussian, std::sqrt(std::max(sigma0 * sigma0 - kCoverageVariance, 0.25)));
  while (true) {
    Octave octave;
    Volume<float> next_octave;
    const GridFrame& frame = gaussian.frame;
    for (int axis = 0; axis < 3; ++axis) box.low[axis] = margin, box.high[axis] = frame.size[axis] - 1 - margin;
    for (int i = 0; i < levels + 2; ++i) {
      const double sigma = sigma0 * std::pow(k, i);
      if (i == levels) next_octave = resampled(gaussian, box, 2, margin);
      Volume<float> blurred = gaussian_blur(gaussian, sigma * std::sqrt(k * k - 1));
      subtract(blurred, -1 / (std::log(k) * ball_response(k)), gaussian);
      octave.levels.push_back(std::move(gaussian));
      octave.sigmas.push_back(sigma * std::sqrt(k) * frame.spacing);
      gaussian = std::move(blurred);
    }
    visit(octave);
    if (octave.sigmas[levels] > largest_sigma) return;
    gaussian = std::move(next_octave);
  }
}

}  // namespace homolog
