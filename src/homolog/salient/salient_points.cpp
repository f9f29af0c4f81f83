// SPDX-License-Identifier: MIT
// Sec. 4.2, 4.3: minima of L_norm among 80 neighbours in space and scale, refined, told once, sorted.
#include "homolog/salient/salient_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "homolog/base/parallel.h"
#include "homolog/salient/refine_peak.h"
#include "homolog/salient/scale_space.h"

namespace homolog {
namespace {

// A voxel answers a little weaker than the peak between the voxels.
constexpr float kVoxelShare = 0.8f;
// Next to the octave below or above both octaves may keep a peak that lies between them; duplicates are merged afterwards.
constexpr float kBorderShare = 0.99f;
// Over the middle of an even plate peaks among voxels are where the grid comes nearest to it: hundreds, and others after every turn. A
// point of the shape falls by more than this share within r / 2 in at least two directions. Asking it in all three leaves .88 instead of
// .78 of the points repeatable under rotation, but takes the points along limbs, a quarter of the right pairs, and gains no match.
constexpr double kLeastSheetFall = 0.003;

// Whether the voxel exceeds its 26 neighbours on its own level. Of equals the one with the lowest index wins, so that a symmetric shape
// centred between voxels is not lost.
bool tops_own_level(const Volume<float>& level, std::size_t voxel) {
  const auto nx = static_cast<std::ptrdiff_t>(level.frame.size[0]), ny = static_cast<std::ptrdiff_t>(level.frame.size[1]);
  const float* f = level.values.data() + voxel;
  for (std::ptrdiff_t k = -1; k <= 1; ++k) {
    for (std::ptrdiff_t j = -1; j <= 1; ++j) {
      for (std::ptrdiff_t i = -1; i <= 1; ++i) {
        const std::ptrdiff_t offset = (k * ny + j) * nx + i;
        if (offset < 0 ? f[offset] >= f[0] : offset > 0 && f[offset] > f[0]) return false;
      }
    }
  }
  return true;
}

// Whether `value` exceeds (or, with `ties`, equals) all 27 neighbours on another level.
bool tops_other_level(const Volume<float>& level, std::size_t voxel, float value, bool ties) {
  const auto nx = static_cast<std::ptrdiff_t>(level.frame.size[0]), ny = static_cast<std::ptrdiff_t>(level.frame.size[1]);
  const float* f = level.values.data() + voxel;
  for (std::ptrdiff_t k = -1; k <= 1; ++k) {
    for (std::ptrdiff_t j = -1; j <= 1; ++j) {
      for (std::ptrdiff_t i = -1; i <= 1; ++i) {
        const float other = f[(k * ny + j) * nx + i];
        if (ties ? other > value : other >= value) return false;
      }
    }
  }
  return true;
}

// Compares with the 80 neighbours; a neighbour on a level that belongs to another octave counts a little less.
bool is_peak(const Octave& octave, int level, std::size_t voxel) {
  const int last = static_cast<int>(octave.levels.size()) - 2;
  const float value = octave.levels[level].values[voxel];
  return tops_own_level(octave.levels[level], voxel) &&
         tops_other_level(octave.levels[level - 1], voxel, level == 1 ? value / kBorderShare : value, false) &&
         tops_other_level(octave.levels[level + 1], voxel, level == last ? value / kBorderShare : value, true);
}

// The peaks of one slice of one level, in index order.
std::vector<Peak> peaks_of_slice(const Octave& octave, int level, int k, float least) {
  const Volume<float>& here = octave.levels[level];
  std::vector<Peak> peaks;
  for (int j = 1; j + 1 < here.frame.size[1]; ++j) {
    const std::size_t row = here.frame.index(0, j, k);
    for (int i = 1; i + 1 < here.frame.size[0]; ++i) {
      if (here.values[row + i] >= least && is_peak(octave, level, row + i)) peaks.push_back({level, {i, j, k}});
    }
  }
  return peaks;
}

std::vector<Peak> find_peaks(const Octave& octave, double threshold) {
  const auto levels = octave.levels.size() - 2, slices = static_cast<std::size_t>(octave.levels[0].frame.size[2]) - 2;
  std::vector<std::vector<Peak>> found(levels * slices);
  parallel_for(found.size(), [&](std::size_t n) {
    found[n] = peaks_of_slice(octave, static_cast<int>(n / slices) + 1, static_cast<int>(n % slices) + 1,
                              static_cast<float>(threshold) * kVoxelShare);
  });
  std::vector<Peak> peaks;
  for (const auto& some : found) peaks.insert(peaks.end(), some.begin(), some.end());
  return peaks;
}

bool larger(const SalientPoint& a, const SalientPoint& b) {
  const auto key = [](const SalientPoint& p) { return std::tuple(-p.radius, p.position[0], p.position[1], p.position[2]); };
  return key(a) < key(b);
}

// The same minimum seen twice: two voxels or two octaves that refine to one place and scale. A true neighbour is at least about r away.
bool same_minimum(const SalientPoint& a, const SalientPoint& b) {
  const double r = std::min(a.radius, b.radius);
  return (a.position - b.position).squaredNorm() < 0.0625 * r * r && std::max(a.radius, b.radius) < 1.2 * r;
}

// Keeps the strongest of the same minima. Sorted by radius, so that partners are near each other in the list.
std::vector<SalientPoint> without_duplicates(const std::vector<SalientPoint>& points) {
  const auto weaker = [&](std::size_t a, std::size_t b) { return std::pair(points[a].response, b) < std::pair(points[b].response, a); };
  std::vector<SalientPoint> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool best = true;
    for (std::size_t j = 0; j < points.size() && best; ++j) best = j == i || !(same_minimum(points[i], points[j]) && weaker(i, j));
    if (best) kept.push_back(points[i]);
  }
  return kept;
}

}  // namespace

std::vector<SalientPoint> find_salient_points(const Interior& interior, const SalientParams& params) {
  const double k = std::pow(2, 1.0 / params.levels_per_octave);
  const ScaleCorrection correction(k);
  std::vector<SalientPoint> points;
  for_each_octave(interior, params, [&](const Octave& octave) {
    const std::vector<Peak> peaks = find_peaks(octave, params.threshold);
    std::vector<RefinedPeak> refined(peaks.size());
    parallel_for(peaks.size(), [&](std::size_t n) { refined[n] = refine_peak(octave, peaks[n], k, correction); });
    for (const RefinedPeak& peak : refined) {
      if (peak.sheet_fall > kLeastSheetFall && peak.point.response >= params.threshold) points.push_back(peak.point);
    }
  });
  std::sort(points.begin(), points.end(), larger);
  return without_duplicates(points);
}

}  // namespace homolog
