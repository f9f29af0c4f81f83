// SPDX-License-Identifier: MIT
// Sec. 4.2, 4.3: minima of L_norm among 80 neighbours in space and scale, refined, told once, sorted.
#include "homolog/salient/salient_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>

#include "homolog/base/parallel.h"
#include "homolog/salient/refine_peak.h"
#include "homolog/salient/scale_space.h"

namespace homolog {
namespace {

// A voxel answers a little weaker than the peak between the voxels.
constexpr float kVoxelShare = 0.8f;
// So many voxels of a row are looked through at once for one that is strong enough.
constexpr int kScanned = 4 * row_block;
// Next to the octave below or above both octaves may keep a peak that lies between them; duplicates are merged afterwards.
constexpr float kBorderShare = 0.99f;
// Over the middle of an even plate peaks among voxels are where the grid comes nearest to it: hundreds, and others after every turn. A
// point of the shape falls by more than this share within r / 2 in at least two directions. Asking it in all three leaves .88 instead of
// .78 of the points repeatable under rotation, but takes the points along limbs, a quarter of the right pairs, and gains no match.
constexpr double kLeastSheetFall = 0.003;

// Whether a voxel exceeds its 26 neighbours on its own level. Of equals the one with the lowest index wins, so that a symmetric shape
// centred between voxels is not lost.
bool tops_own_level(const Octave& octave, int level, int i, int j, int k) {
  const float value = octave.at(level, i, j, k);
  for (int n = 0; n < 27; ++n) {
    const float other = octave.at(level, i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1);
    if (n < 13 ? other >= value : other > value) return false;
  }
  return true;
}

// Whether `value` exceeds (or, with `ties`, equals) all 27 neighbours on another level.
bool tops_other_level(const Octave& octave, int level, int i, int j, int k, float value, bool ties) {
  for (int n = 0; n < 27; ++n) {
    const float other = octave.at(level, i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1);
    if (ties ? other > value : other >= value) return false;
  }
  return true;
}

// Whether a voxel exceeds its 80 neighbours; one on a level of another octave counts a little less.
bool is_peak(const Octave& octave, int level, int i, int j, int k) {
  const float value = octave.at(level, i, j, k);
  const float lower = level == 1 ? value / kBorderShare : value, upper = level == octave.levels() - 2 ? value / kBorderShare : value;
  return tops_own_level(octave, level, i, j, k) && tops_other_level(octave, level - 1, i, j, k, lower, false) &&
         tops_other_level(octave, level + 1, i, j, k, upper, true);
}

// The peaks of one row of a level. Where it is constant there are none. `kinds` is memory for those of its blocks.
void append_peaks_of_row(const Octave& octave, int level, int j, int k, float least, std::vector<std::uint8_t>& kinds,
                         std::vector<Peak>& peaks) {
  const RollingVolume &finer = octave.blurred[level], &coarser = octave.blurred[level + 1];
  const float *fine = finer.row(j, k), *coarse = coarser.row(j, k);
  const auto at = [&](int i) { return octave.factor * (fine[i] - coarse[i]); };  // octave.at() looks for the rows each time
  kinds.assign(finer.kinds(j, k), finer.kinds(j, k) + finer.blocks());
  join_kinds(coarser.kinds(j, k), finer.blocks(), kinds.data());
  for_mixed_runs(kinds.data(), finer.blocks(), [&](int begin, int end) {
    for (int x = begin; x < end; x += kScanned) {
      const int stop = std::min(end, x + kScanned);
      if (largest_difference(fine, coarse, octave.factor, x, stop) < least) continue;
      for (int i = std::max(1, x); i < std::min(stop, octave.frame().size[0] - 1); ++i) {
        const float value = at(i);
        if (value < least || at(i - 1) >= value || at(i + 1) > value) continue;  // as most
        if (is_peak(octave, level, i, j, k)) peaks.push_back({level, {i, j, k}});
      }
    }
  });
}

// The peaks of the octave's new slices; slices on the border have no neighbours beyond.
std::vector<Peak> find_peaks(const Octave& octave, double threshold) {
  const int first = std::max(1, octave.first), end = std::min(octave.end, octave.frame().size[2] - 1);
  const int levels = octave.levels() - 2;
  std::vector<std::vector<Peak>> found(static_cast<std::size_t>(std::max(0, end - first)) * levels);
  parallel_for(found.size(), [&](std::size_t n) {
    const int level = static_cast<int>(n) % levels + 1, k = first + static_cast<int>(n) / levels;
    std::vector<std::uint8_t> kinds;
    for (int j = 1; j + 1 < octave.frame().size[1]; ++j) {
      append_peaks_of_row(octave, level, j, k, static_cast<float>(threshold) * kVoxelShare, kinds, found[n]);
    }
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
  for_each_octave(interior, params, refinement_reach(params), [&](const Octave& octave) {
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
