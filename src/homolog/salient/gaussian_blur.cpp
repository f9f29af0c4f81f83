// SPDX-License-Identifier: MIT
// Sec. 4.1, 4.3: separable Gaussian blur. Two sweeps: x and y inside a slice, then z inside a plane of constant y, each in cache.
#include "homolog/salient/gaussian_blur.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "homolog/base/parallel.h"

// A wider twin of the inner loop, chosen at run time. AVX2 without FMA rounds like SSE2, so the bytes stay the same.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__)
#define HOMOLOG_WIDE_CLONE __attribute__((target_clones("avx2", "default")))
#else
#define HOMOLOG_WIDE_CLONE
#endif

namespace homolog {
namespace {

constexpr int kBlock = 32;  // floats summed at once, in registers

// The part of a row that may be nonzero: [low, high).
struct Run {
  int low = 0, high = 0;
  bool empty() const { return low >= high; }
};

// out[x] = sum_t weights[|t|] in[x + t stride], for x in [0, count).
HOMOLOG_WIDE_CLONE void convolve(const float* in, std::ptrdiff_t stride, const float* weights, int radius, int count, float* out) {
  int x = 0;
  while (count - x >= kBlock) {
    float sum[kBlock];
    for (int i = 0; i < kBlock; ++i) sum[i] = weights[0] * in[x + i];
    for (int t = 1; t <= radius; ++t) {
      const float *before = in + x - t * stride, *after = in + x + t * stride;
      for (int i = 0; i < kBlock; ++i) sum[i] += weights[t] * (before[i] + after[i]);
    }
    for (int i = 0; i < kBlock; ++i) out[x + i] = sum[i];
    x += kBlock;
    if (x < count && count >= kBlock) x = std::min(x, count - kBlock);  // the last block overlaps the one before
  }
  for (; x < count; ++x) {
    float sum = weights[0] * in[x];
    for (int t = 1; t <= radius; ++t) sum += weights[t] * (in[x - t * stride] + in[x + t * stride]);
    out[x] = sum;
  }
}

Run nonzero_run(const float* row, int count) {
  int low = 0, high = count;
  while (low < high && row[low] == 0) ++low;
  while (high > low && row[high - 1] == 0) --high;
  return {low, high};
}

// What a blur can reach from a run, made long enough for a whole block where the row allows.
Run grown(const Run& run, int radius, int count) {
  if (run.empty()) return {};
  const int low = std::max(0, run.low - radius), high = std::min(count, run.high + radius);
  return {std::max(0, std::min(low, count - kBlock)), std::max(high, std::min(count, low + kBlock))};
}

// The union of the runs of rows [row - radius, row + radius].
Run joined(const std::vector<Run>& runs, int row, int radius) {
  Run all;
  for (int r = std::max(0, row - radius); r <= std::min(static_cast<int>(runs.size()) - 1, row + radius); ++r) {
    if (runs[r].empty()) continue;
    all = all.empty() ? runs[r] : Run{std::min(all.low, runs[r].low), std::max(all.high, runs[r].high)};
  }
  return all;
}

// Rows one under the other, with `radius` zero rows above and below, so that sums along columns need no test for the border.
struct Sheet {
  int count, radius;
  std::vector<float> values;
  std::vector<Run> runs;

  Sheet(int row_length, int rows, int kernel_radius)
      : count(row_length), radius(kernel_radius), values(static_cast<std::size_t>(row_length) * (rows + 2 * kernel_radius)), runs(rows) {}
  float* row(int r) { return values.data() + static_cast<std::size_t>(r + radius) * count; }

  // Row r of the sheet summed along the column; what no row reaches stays untouched. Returns the run written.
  Run sum_column(int r, const std::vector<float>& weights, float* out) {
    const Run run = joined(runs, r, radius);
    if (!run.empty()) convolve(row(r) + run.low, count, weights.data(), radius, run.high - run.low, out + run.low);
    return run;
  }
};

// Sweep 1: slice k blurred along x and y. Notes the runs of its rows, row by row.
void blur_slice(const Volume<float>& in, int k, const std::vector<float>& weights, Volume<float>& out, std::vector<Run>& runs) {
  const int radius = static_cast<int>(weights.size()) - 1, nx = in.frame.size[0], ny = in.frame.size[1];
  Sheet sheet(nx, ny, radius);
  std::vector<float> padded(static_cast<std::size_t>(nx + 2 * radius));
  for (int j = 0; j < ny; ++j) {
    const float* row = &in.at(0, j, k);
    const Run run = nonzero_run(row, nx);
    sheet.runs[j] = grown(run, radius, nx);
    if (run.empty()) continue;
    std::copy(row, row + nx, padded.begin() + radius);
    const Run& reach = sheet.runs[j];
    convolve(padded.data() + radius + reach.low, 1, weights.data(), radius, reach.high - reach.low, sheet.row(j) + reach.low);
  }
  for (int j = 0; j < ny; ++j) runs[static_cast<std::size_t>(k) * ny + j] = sheet.sum_column(j, weights, &out.at(0, j, k));
}

// Sweep 2: the plane of constant j blurred along z, in place.
void blur_plane(int j, const std::vector<float>& weights, const std::vector<Run>& runs, Volume<float>& volume) {
  const int nx = volume.frame.size[0], ny = volume.frame.size[1], nz = volume.frame.size[2];
  Sheet sheet(nx, nz, static_cast<int>(weights.size()) - 1);
  for (int k = 0; k < nz; ++k) {
    const Run& run = sheet.runs[k] = runs[static_cast<std::size_t>(k) * ny + j];
    if (!run.empty()) std::copy(&volume.at(run.low, j, k), &volume.at(run.low, j, k) + (run.high - run.low), sheet.row(k) + run.low);
  }
  for (int k = 0; k < nz; ++k) sheet.sum_column(k, weights, &volume.at(0, j, k));
}

std::vector<double> sampled_gaussian(double sigma, int radius) {
  std::vector<double> weights(radius + 1);
  double sum = 0;
  for (int t = 0; t <= radius; ++t) sum += (t == 0 ? 1 : 2) * (weights[t] = std::exp(-t * t / (2 * sigma * sigma)));
  for (double& w : weights) w /= sum;
  return weights;
}

}  // namespace

std::vector<float> gaussian_kernel(double sigma) {
  const int radius = std::max(1, static_cast<int>(std::ceil(3.5 * sigma)));
  double nominal = sigma;  // cutting the tails costs variance: widen until it is right again
  std::vector<double> weights;
  for (int step = 0; step < 8; ++step) {
    weights = sampled_gaussian(nominal, radius);
    double variance = 0;
    for (int t = 1; t <= radius; ++t) variance += 2 * weights[t] * t * t;
    nominal *= sigma / std::sqrt(variance);
  }
  return {weights.begin(), weights.end()};
}

Volume<float> gaussian_blur(const Volume<float>& volume, double sigma) {
  const std::vector<float> weights = gaussian_kernel(sigma);
  const int ny = volume.frame.size[1], nz = volume.frame.size[2];
  Volume<float> result{volume.frame, std::vector<float>(volume.values.size())};
  std::vector<Run> runs(static_cast<std::size_t>(ny) * nz);
  parallel_for(nz, [&](std::size_t k) { blur_slice(volume, static_cast<int>(k), weights, result, runs); });
  parallel_for(ny, [&](std::size_t j) { blur_plane(static_cast<int>(j), weights, runs, result); });
  return result;
}

}  // namespace homolog
