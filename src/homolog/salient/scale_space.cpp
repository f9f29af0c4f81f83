// SPDX-License-Identifier: MIT
// Sec. 4.2, 4.3: octaves of incrementally blurred coverage, each with its own margin of zeros, so that nothing is lost at the border.
#include "homolog/salient/scale_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "homolog/base/parallel.h"
#include "homolog/salient/growing_octave.h"

namespace homolog {
namespace {

// Mass of a unit 3D Gaussian within radius t.
double mass_within(double t) { return std::erf(t / std::sqrt(2)) - std::sqrt(2 / M_PI) * t * std::exp(-t * t / 2); }

struct VoxelBox {
  std::array<int, 3> low, high;  // inclusive
};

// The nonzero part of a row.
Run nonzero_run(const float* row, int count) {
  int low = 0, high = count;
  while (low < high && row[low] == 0) ++low;
  while (high > low && row[high - 1] == 0) --high;
  return {low, high};
}

// The smallest box of all nonempty voxels.
VoxelBox content_of(const Interior& interior) {
  const auto& size = interior.frame.size;
  VoxelBox box{size, {-1, -1, -1}};
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      const float* row = interior.values.data() + interior.frame.index(0, j, k);
      const Run run = nonzero_run(row, size[0]);
      if (run.empty()) continue;
      box.low = {std::min(box.low[0], run.low), std::min(box.low[1], j), std::min(box.low[2], k)};
      box.high = {std::max(box.high[0], run.high - 1), std::max(box.high[1], j), std::max(box.high[2], k)};
    }
  }
  return box;
}

// Every step-th voxel of a box, with `margin` voxels around it.
GridFrame frame_around(const GridFrame& source, const VoxelBox& box, int step, int margin) {
  GridFrame frame;
  std::array<int, 3> first{};
  for (int axis = 0; axis < 3; ++axis) {
    frame.size[axis] = (box.high[axis] - box.low[axis] + step - 1) / step + 1 + 2 * margin;
    first[axis] = box.low[axis] - step * margin;
  }
  frame.spacing = step * source.spacing;
  frame.axes = source.axes;
  frame.origin = source.world_from_voxel(Vec3(first[0], first[1], first[2]));
  return frame;
}

// Slice k of the padded coverage: voxel v of it is voxel v + shift of the interior.
void copy_coverage(const Interior& interior, const std::array<int, 3>& shift, int k, RollingVolume& padded) {
  for (int j = 0; j < padded.frame().size[1]; ++j) {
    const int y = j + shift[1], z = k + shift[2];
    const bool known = y >= 0 && z >= 0 && y < interior.frame.size[1] && z < interior.frame.size[2];
    const float* row = known ? &interior.at(0, y, z) : nullptr;
    const Run run = known ? nonzero_run(row, interior.frame.size[0]) : Run{};
    float* copy = padded.begin_row(j, k, run.empty() ? Run{} : Run{run.low - shift[0], run.high - shift[0]});
    if (!run.empty()) std::copy(row + run.low, row + run.high, copy + run.low - shift[0]);
  }
}

// The lowest level of the first octave.
class BlurredCoverage {
 public:
  BlurredCoverage(const Interior& interior, const std::array<int, 3>& shift, const GridFrame& frame, double sigma)
      : interior_(interior), shift_(shift), padded_(frame, growth_step), blur_(frame, sigma, growth_step) {}

  // Makes the next slices after the first `made`; returns how many there are then.
  int make(int made, RollingVolume& level) {
    while (blur_.ready() <= made) {
      const int first = blur_.taken(), end = std::min(first + growth_step, level.frame().size[2]);
      parallel_for(static_cast<std::size_t>(end - first),
                   [&](std::size_t k) { copy_coverage(interior_, shift_, first + static_cast<int>(k), padded_); });
      blur_.take(padded_, end);
    }
    const int end = std::min(blur_.ready(), made + growth_step);
    blur_.give(made, end, level, [](int, int) {});
    return end;
  }

 private:
  const Interior& interior_;
  std::array<int, 3> shift_;
  RollingVolume padded_;
  RollingBlur blur_;
};

// Row j of slice k of a level, if it belongs to the next octave: that has every second voxel, from voxel -margin on.
void halve_row(const RollingVolume& level, int j, int k, int margin, RollingVolume& next) {
  const auto& size = next.frame().size;
  if ((j + margin) % 2 != 0 || (k + margin) % 2 != 0 || (j + margin) / 2 >= size[1] || (k + margin) / 2 >= size[2]) return;
  const Run& run = level.run(j, k);
  const Run halved{(run.low + margin + 1) / 2, std::min(size[0], (run.high - 1 + margin) / 2 + 1)};
  float* target = next.begin_row((j + margin) / 2, (k + margin) / 2, run.empty() ? Run{} : halved);
  if (run.empty()) return;
  const float* row = level.row(j, k);
  for (int i = halved.low; i < halved.high; ++i) target[i] = row[2 * i - margin];
}

}  // namespace

double ball_level(double sigma, double k) {
  const double t = std::sqrt(k) / sigma;  // r / s, the lower of the two blurs
  return (mass_within(t / k) - mass_within(t)) / std::log(k);
}

double radius_factor(double k) { return std::sqrt(3 * std::log(k) / std::sinh(std::log(k))); }

double ball_response(double k) { return ball_level(1 / radius_factor(k), k); }

void for_each_octave(const Interior& interior, const SalientParams& params, int reach, const std::function<void(const Octave&)>& visit) {
  const double k = std::pow(2, 1.0 / params.levels_per_octave), sigma0 = params.sigma0;
  const int margin = static_cast<int>(std::ceil(5 * sigma0));  // 2.5 blurs of the level that goes on to the next octave
  VoxelBox box = content_of(interior);
  if (box.high[0] < 0) return;
  const Vec3 extent(box.high[0] - box.low[0] + 1, box.high[1] - box.low[1] + 1, box.high[2] - box.low[2] + 1);
  const double largest_sigma = interior.frame.spacing * extent.norm() / 2 / radius_factor(k);

  GridFrame frame = frame_around(interior.frame, box, 1, margin);
  BlurredCoverage coverage(interior, {box.low[0] - margin, box.low[1] - margin, box.low[2] - margin}, frame,
                           std::sqrt(std::max(sigma0 * sigma0 - coverage_variance, 0.25)));
  std::optional<RollingVolume> lowest;
  while (true) {
    for (int axis = 0; axis < 3; ++axis) box.low[axis] = margin, box.high[axis] = frame.size[axis] - 1 - margin;
    const GridFrame next_frame = frame_around(frame, box, 2, margin);
    RollingVolume next(next_frame, next_frame.size[2]);
    GrowingOctave octave(frame, params, reach);
    if (lowest) octave.begin_with(std::move(*lowest));
    octave.grow([&](int made, RollingVolume& level) { return coverage.make(made, level); },
                [&](const RollingVolume& level, int row, int slice) { halve_row(level, row, slice, margin, next); }, visit);
    if (sigma0 * std::pow(k, params.levels_per_octave + 0.5) * frame.spacing > largest_sigma) return;
    lowest = std::move(next);
    frame = next_frame;
  }
}

}  // namespace homolog
