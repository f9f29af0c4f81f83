// SPDX-License-Identifier: MIT
// Sec. 4.2, 4.3: octaves of incrementally blurred coverage, each with its own margin of zeros, so that nothing is lost at the border.
#include "homolog/salient/scale_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "homolog/salient/growing_octave.h"

namespace homolog {
namespace {

// Mass of a unit 3D Gaussian within radius t.
double mass_within(double t) { return std::erf(t / std::sqrt(2)) - std::sqrt(2 / M_PI) * t * std::exp(-t * t / 2); }

struct VoxelBox {
  std::array<int, 3> low, high;  // inclusive
};

// The nonzero part of a row: [low, high).
struct Run {
  int low = 0, high = 0;
  bool empty() const { return low >= high; }
};
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

// Row j of slice k of the padded coverage: voxel v of it is voxel v + shift of the interior.
void copy_coverage(const Interior& interior, const std::array<int, 3>& shift, int j, int k, RollingVolume& padded) {
  const auto& size = interior.frame.size;
  const int y = j + shift[1], z = k + shift[2];
  const bool known = y >= 0 && z >= 0 && y < size[1] && z < size[2];
  float* copy = padded.begin_row(j, k, std::vector<std::uint8_t>(padded.blocks(), known ? mixed_block : empty_block).data());
  if (!known) return;
  const int low = std::max(0, shift[0]), high = std::min(size[0], padded.frame().size[0] + shift[0]);
  std::fill(copy, copy + low - shift[0], 0.0f);
  std::copy(&interior.at(low, y, z), &interior.at(low, y, z) + high - low, copy + low - shift[0]);
  std::fill(copy + high - shift[0], copy + padded.blocks() * row_block, 0.0f);
  padded.end_row(j, k);
}

// A volume held as a whole.
RollingVolume empty_volume(const GridFrame& frame, float plateau) {
  RollingVolume volume(frame, frame.size[2], plateau);
  const std::vector<std::uint8_t> kinds(volume.blocks(), empty_block);
  for (int k = 0; k < frame.size[2]; ++k) {
    for (int j = 0; j < frame.size[1]; ++j) volume.begin_row(j, k, kinds.data());
  }
  return volume;
}

// Row j of slice k of a level, if it belongs to the next octave: that has every second voxel, from voxel -margin on.
void halve_row(const RollingVolume& level, int j, int k, int margin, RollingVolume& next) {
  const auto& size = next.frame().size;
  if ((j + margin) % 2 != 0 || (k + margin) % 2 != 0 || (j + margin) / 2 >= size[1] || (k + margin) / 2 >= size[2]) return;
  const int y = (j + margin) / 2, z = (k + margin) / 2, first = (margin + 1) / 2;
  const int end = std::min(size[0], (level.frame().size[0] - 1 + margin) / 2 + 1);
  float* target = next.begin_row(y, z, std::vector<std::uint8_t>(next.blocks(), mixed_block).data());
  const float* row = level.row(j, k);
  for (int i = first; i < end; ++i) target[i] = row[2 * i - margin];
  next.end_row(y, z);
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
  const std::array<int, 3> shift{box.low[0] - margin, box.low[1] - margin, box.low[2] - margin};
  std::optional<RollingVolume> lowest;
  while (true) {
    for (int axis = 0; axis < 3; ++axis) box.low[axis] = margin, box.high[axis] = frame.size[axis] - 1 - margin;
    const GridFrame next_frame = frame_around(frame, box, 2, margin);
    GrowingOctave octave(frame, params, reach, std::move(lowest));
    RollingVolume next = empty_volume(next_frame, octave.doubled_plateau());
    octave.grow([&](RollingVolume& coverage, int row, int slice) { copy_coverage(interior, shift, row, slice, coverage); },
                [&](const RollingVolume& level, int row, int slice) { halve_row(level, row, slice, margin, next); }, visit);
    if (sigma0 * std::pow(k, params.levels_per_octave + 0.5) * frame.spacing > largest_sigma) return;
    lowest = std::move(next);
    frame = next_frame;
  }
}

}  // namespace homolog
