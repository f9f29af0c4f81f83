// SPDX-License-Identifier: MIT
// Sec. 4.2, 4.3: minima of L_norm among 80 neighbours in space and scale, refined, told once, sorted.
#include "homolog/salient/salient_points.h"

#include <algorithm>
#include <array>
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

// Rows j - 1 to j + 1 of slices k - 1 to k + 1 of a level.
using Rows = std::array<const float*, 9>;

Rows rows_around(const RollingVolume& level, int j, int k) {
  Rows rows;
  for (int n = 0; n < 9; ++n) rows[n] = level.row(j + n % 3 - 1, k + n / 3 - 1);
  return rows;
}

// Whether the voxel exceeds its 26 neighbours on its own level. Of equals the one with the lowest index wins, so that a symmetric shape
// centred between voxels is not lost.
bool tops_own_level(const Rows& rows, int i) {
  const float value = rows[4][i];
  for (int n = 0; n < 27; ++n) {
    const float other = rows[n / 3][i + n % 3 - 1];
    if (n < 13 ? other >= value : other > value) return false;
  }
  return true;
}

// Whether `value` exceeds (or, with `ties`, equals) all 27 neighbours on another level.
bool tops_other_level(const Rows& rows, int i, float value, bool ties) {
  for (int n = 0; n < 27; ++n) {
    const float other = rows[n / 3][i + n % 3 - 1];
    if (ties ? other > value : other >= value) return false;
  }
  return true;
}

// The peaks of one row of a level, each compared with its 80 neighbours; one on a level of another octave counts a little less.
void append_peaks_of_row(const Octave& octave, int level, int j, int k, float least, std::vector<Peak>& peaks) {
  const int last = static_cast<int>(octave.levels.size()) - 2;
  const Run& run = octave.levels[level].run(j, k);
  const float* row = octave.levels[level].row(j, k);
  for (int i = std::max(1, run.low); i < std::min(run.high, octave.frame().size[0] - 1); ++i) {
    if (row[i] < least || row[i - 1] >= row[i] || row[i + 1] > row[i] || !tops_own_level(rows_around(octave.levels[level], j, k), i))
      continue;
    const float lower = level == 1 ? row[i] / kBorderShare : row[i], upper = level == last ? row[i] / kBorderShare : row[i];
    if (tops_other_level(rows_around(octave.levels[level - 1], j, k), i, lower, false) &&
        tops_other_level(rows_around(octave.levels[level + 1], j, k), i, upper, true)) {
      peaks.push_back({level, {i, j, k}});
    }
  }
}

// The peaks of the octave's new slices; slices on the border have no neighbours beyond.
std::vector<Peak> find_peaks(const Octave& octave, double threshold) {
  const int first = std::max(1, octave.first), end = std::min(octave.end, octave.frame().size[2] - 1);
  const int levels = static_cast<int>(octave.levels.size()) - 2;
  std::vector<std::vector<Peak>> found(static_cast<std::size_t>(std::max(0, end - first)) * levels);
  parallel_for(found.size(), [&](std::size_t n) {
    const int level = static_cast<int>(n) % levels + 1, k = first + static_cast<int>(n) / levels;
    for (int j = 1; j + 1 < octave.frame().size[1]; ++j) {
      append_peaks_of_row(octave, level, j, k, static_cast<float>(threshold) * kVoxelShare, found[n]);
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
