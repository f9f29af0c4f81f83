// SPDX-License-Identifier: MIT
#include "homolog/salient/gaussian_blur.h"

#include <algorithm>
#include <cmath>

#include "homolog/base/parallel.h"

namespace homolog {
namespace {

std::vector<double> sampled_gaussian(double sigma, int radius) {
  std::vector<double> weights(radius + 1);
  double sum = 0;
  for (int t = 0; t <= radius; ++t) sum += (t == 0 ? 1 : 2) * (weights[t] = std::exp(-t * t / (2 * sigma * sigma)));
  for (double& w : weights) w /= sum;
  return weights;
}

// What a blur can reach from a run.
Run grown(const Run& run, int radius, int count) {
  if (run.empty()) return {};
  return {std::max(0, run.low - radius), std::min(count, run.high + radius)};
}

// A row blurred along itself, by way of a copy between zeros.
class RowBlur {
 public:
  RowBlur(const std::vector<float>& weights, int stride)
      : weights_(weights),
        radius_(static_cast<int>(weights.size()) - 1),
        padded_(stride + 2 * weights.size()),
        shifted_(2 * weights.size() - 1) {
    for (std::size_t t = 0; t < shifted_.size(); ++t) shifted_[t] = padded_.data() + t;
  }

  void operator()(const float* row, const Run& run, const Run& reach, float* out) {
    std::copy(row + run.low, row + run.high, padded_.begin() + radius_ + run.low);
    weigh_rows(shifted_.data() + radius_, weights_.data(), radius_, block_begin(reach), block_end(reach), out);
    std::fill(padded_.begin() + radius_ + run.low, padded_.begin() + radius_ + run.high, 0.0f);
  }

 private:
  const std::vector<float>& weights_;
  int radius_;
  std::vector<float> padded_;
  std::vector<const float*> shifted_;
};

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

RollingBlur::RollingBlur(const GridFrame& frame, double sigma, int chunk)
    : weights_(gaussian_kernel(sigma)), flat_(frame, 2 * radius() + chunk) {}

// Rows are blurred along x on to a sheet that rolls along y, whose columns are summed while they are hot.
void RollingBlur::blur_slice(const RollingVolume& volume, int k) {
  const auto& [nx, ny, nz] = flat_.frame().size;
  GridFrame standing = flat_.frame();
  standing.size = {nx, 1, ny};
  RollingVolume sheet(standing, 2 * radius() + 1);
  RowBlur blur_row(weights_, flat_.stride());
  std::vector<const float*> rows(2 * radius() + 1);
  for (int j = 0; j < ny + radius(); ++j) {
    if (j < ny) {
      const Run& run = volume.run(j, k);
      const Run reach = grown(run, radius(), nx);
      float* row = sheet.begin_row(0, j, reach);
      if (!run.empty()) blur_row(volume.row(j, k), run, reach, row);
    }
    const int summed = j - radius();
    if (summed < 0) continue;
    const Run run = sheet.column(0, summed, rows);
    float* row = flat_.begin_row(summed, k, run);
    if (!run.empty()) weigh_rows(rows.data() + radius(), weights_.data(), radius(), block_begin(run), block_end(run), row);
  }
}

void RollingBlur::take(const RollingVolume& volume, int end) {
  const int first = taken_;
  parallel_for(static_cast<std::size_t>(end - first), [&](std::size_t k) { blur_slice(volume, first + static_cast<int>(k)); });
  taken_ = end;
}

int RollingBlur::ready() const { return taken_ == flat_.frame().size[2] ? taken_ : std::max(0, taken_ - radius()); }

void RollingBlur::give(int first, int end, RollingVolume& blurred, const std::function<void(int, int)>& done) const {
  parallel_for(static_cast<std::size_t>(flat_.frame().size[1]), [&](std::size_t row_number) {
    const int j = static_cast<int>(row_number);
    std::vector<const float*> rows(2 * radius() + 1);
    for (int k = first; k < end; ++k) {
      const Run run = flat_.column(j, k, rows);
      float* row = blurred.begin_row(j, k, run);
      if (!run.empty()) weigh_rows(rows.data() + radius(), weights_.data(), radius(), block_begin(run), block_end(run), row);
      done(j, k);
    }
  });
}

}  // namespace homolog
