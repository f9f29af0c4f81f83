// SPDX-License-Identifier: MIT
#include "homolog/shape/inside.h"

#include <algorithm>
#include <utility>

#include "homolog/base/large_memory.h"
#include "homolog/base/widest_clone.h"
#include "homolog/shape/axis_sums.h"
#include "homolog/shape/exact_coverage.h"
#include "homolog/shape/settle_by_winding.h"

namespace homolog {
namespace {

constexpr float agreement = 0.5f;  // rays of two axes sample the skin differently, but the inside of a voxel not by more than this
constexpr float most_lost = 0.5f;  // of a column's rays: beyond it, its axis has no vote

enum Verdict : std::uint8_t { by_three, by_two, disputed };  ///< how many axes agree

struct Vote {
  float coverage;
  Verdict verdict;
};

Vote vote(const std::array<float, 3>& value, const std::array<float, 3>& lost) {
  float sum = 0, low = 2, high = -1;
  int votes = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (lost[axis] > most_lost) continue;
    ++votes;
    const float own = value[axis] / (1 - lost[axis]);
    sum += own;
    low = std::min(low, own);
    high = std::max(high, own);
  }
  if (votes < 2 || high - low > agreement) return {0, disputed};
  return {sum / static_cast<float>(votes), votes == 3 ? by_three : by_two};
}

/// The mean of three axes. Where all say nothing, nothing is written: the volume is empty and large.
HOMOLOG_WIDEST_CLONE void write_mean(const RowSums& row, std::size_t length, float* coverage) {
  const auto& [a, b, c] = row.sums;
  std::int32_t any = 0;
  for (std::size_t x = 0; x < length; ++x) any |= a[x] | b[x] | c[x];
  if (any == 0) return;
  for (std::size_t x = 0; x < length; ++x) coverage[x] = static_cast<float>(a[x] + b[x] + c[x]) / (3.0f * full_coverage);
}

/// As vote(), with nothing lost.
HOMOLOG_WIDEST_CLONE void write_votes_of_all(const RowSums& row, std::size_t length, float* coverage, std::uint8_t* verdicts) {
  const auto& [a, b, c] = row.sums;
  for (std::size_t x = 0; x < length; ++x) {
    const std::int32_t apart = std::max({a[x], b[x], c[x]}) - std::min({a[x], b[x], c[x]});
    const bool agree = apart <= static_cast<std::int32_t>(agreement * full_coverage);
    const float mean = static_cast<float>(a[x] + b[x] + c[x]) / (3.0f * full_coverage);
    coverage[x] = agree ? mean : 0;
    verdicts[x] = agree ? by_three : disputed;
  }
}

void write_votes(const RowSums& row, std::size_t length, float* coverage, std::uint8_t* verdicts) {
  const auto share = [](std::int32_t sum) { return static_cast<float>(sum) / full_coverage; };
  for (std::size_t x = 0; x < length; ++x) {
    const Vote of_axes =
        vote({share(row.sums[0][x]), share(row.sums[1][x]), share(row.sums[2][x])}, {row.lost_x, row.lost_y[x], row.lost_z[x]});
    coverage[x] = of_axes.coverage;
    verdicts[x] = of_axes.verdict;
  }
}

}  // namespace

std::vector<float> coverage_by_rays(const GridSurface& surface) {
  std::vector<float> coverage = large_zeros(surface.voxels());
  const std::size_t nx = surface.size[0], ny = surface.size[1];
  visit_axis_sums(surface, [&](const RowSums& row) { write_mean(row, nx, coverage.data() + (row.z * ny + row.y) * nx); });
  return coverage;
}

Inside inside_of_closed(const GridSurface& surface) {
  std::vector<float> coverage = exact_coverage(surface);
  if (coverage.empty()) coverage = coverage_by_rays(surface);
  return {std::move(coverage), 0};
}

Inside inside_of_open(const GridSurface& surface) {
  Inside result{large_zeros(surface.voxels()), 0};
  std::vector<std::uint8_t> verdicts(surface.voxels(), by_three);
  const std::size_t nx = surface.size[0], ny = surface.size[1];
  visit_axis_sums(surface, [&](const RowSums& row) {
    const std::size_t first = (row.z * ny + row.y) * nx;
    (row.any_lost ? write_votes : write_votes_of_all)(row, nx, result.coverage.data() + first, verdicts.data() + first);
  });
  std::vector<std::uint8_t> disputed_voxels(verdicts.size());
  bool vouched = false;  // winding numbers alone would fill the hollow side of any sheet
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    disputed_voxels[i] = verdicts[i] == disputed;
    vouched = vouched || (!disputed_voxels[i] && result.coverage[i] > 0);
  }
  if (!vouched) return {std::vector<float>(surface.voxels(), 0), 0};
  settle_by_winding(surface, disputed_voxels, result.coverage);
  double inside = 0, guessed = 0;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    inside += result.coverage[i];
    if (verdicts[i] != by_three) guessed += result.coverage[i];
  }
  if (inside > 0) result.guessed = guessed / inside;
  return result;
}

}  // namespace homolog
