// SPDX-License-Identifier: MIT
#include "homolog/salient/gaussian_blur.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace homolog {
namespace {

std::vector<double> sampled_gaussian(double sigma, int radius) {
  std::vector<double> weights(radius + 1);
  double sum = 0;
  for (int t = 0; t <= radius; ++t) sum += (t == 0 ? 1 : 2) * (weights[t] = std::exp(-t * t / (2 * sigma * sigma)));
  for (double& w : weights) w /= sum;
  return weights;
}

// What is the sum of constant rows.
float constant_sum(const RowWeights& weights, float value) {
  const std::vector<float> row(row_block + 2 * weights.radius(), value);
  float sums[row_block];
  weigh_along(row.data() + weights.radius(), weights, std::numeric_limits<float>::infinity(), 0, row_block, sums);
  return sums[0];
}

// The sums of a band of rows in row_group slices: along z on to a sheet that rolls along y, along y on to a few flat rows, along x.
class BandSums {
 public:
  BandSums(const RowWeights& weights, const RollingVolume& volume, int first_slice, int first_row)
      : weights_(weights),
        volume_(volume),
        first_slice_(first_slice),
        made_(first_row - weights.radius()),
        border_((weights.radius() + row_block - 1) / row_block),
        sheet_(volume.blocks(), 2 * weights.radius() + row_group, row_group, constant_sum(weights, volume.plateau())),
        flat_(volume.blocks() + 2 * border_, 1, row_group, constant_sum(weights, sheet_.plateau())),
        plateau_(constant_sum(weights, flat_.plateau())),
        rows_(2 * weights.radius() + row_group),
        sheet_rows_(rows_.size()),
        kinds_(flat_.blocks()) {}

  // Prepares the rows j to j + row_group - 1; j grows by row_group from call to call.
  void begin_rows(int j) {
    for (; made_ < j + row_group + weights_.radius(); ++made_) sum_along_z();
    for (std::size_t t = 0; t < rows_.size(); ++t) sheet_rows_[t] = sheet_.row(slot_of(made_ + static_cast<int>(t)));
    join_sheet();
    flat_.begin(0, kinds_.data());
    for (int b = 0; b < volume_.blocks(); ++b) {
      kinds_[b] = unset_block;
      for (int d = 0; d <= 2 * border_; ++d) kinds_[b] |= flat_.kinds(0)[b + d];
    }
  }

  // What the blocks of every row of begin_rows may hold.
  const std::uint8_t* kinds() const { return kinds_.data(); }

  void sum_along_y(int slice) {
    const std::ptrdiff_t offset = slice * static_cast<std::ptrdiff_t>(volume_.blocks()) * row_block;
    for (std::size_t t = 0; t < rows_.size(); ++t) rows_[t] = sheet_rows_[t] + offset;
    float* sums[row_group];
    for (int n = 0; n < row_group; ++n) sums[n] = flat_.row(0, n) + border_ * row_block;
    for_mixed_runs(flat_.kinds(0) + border_, volume_.blocks(),
                   [&](int begin, int end) { weigh_across(rows_.data(), weights_, begin, end, sums); });
  }

  void sum_along_x(int n, float* sums) const {
    for_mixed_runs(kinds(), volume_.blocks(),
                   [&](int begin, int end) { weigh_along(flat_.row(0, n) + border_ * row_block, weights_, plateau_, begin, end, sums); });
  }

 private:
  // Row made_ of all slices.
  void sum_along_z() {
    const std::size_t slot = slot_of(made_);
    volume_.column(made_, first_slice_ - weights_.radius(), rows_, kinds_);
    sheet_.begin(slot, kinds_.data());
    float* sums[row_group];
    for (int n = 0; n < row_group; ++n) sums[n] = sheet_.row(slot, n);
    for_mixed_runs(kinds(), volume_.blocks(), [&](int begin, int end) { weigh_across(rows_.data(), weights_, begin, end, sums); });
  }

  // Rows before the first one of the volume count from -radius.
  std::size_t slot_of(int j) const { return static_cast<std::size_t>(j + weights_.radius()) % rows_.size(); }

  // What the sums along y may hold, between borders of zeros.
  void join_sheet() {
    std::fill(kinds_.begin(), kinds_.end(), empty_block);
    std::fill_n(kinds_.begin() + border_, volume_.blocks(), unset_block);
    for (std::size_t slot = 0; slot < rows_.size(); ++slot) {
      join_kinds(sheet_.kinds(slot), volume_.blocks(), &kinds_[border_]);
    }
  }

  const RowWeights& weights_;
  const RollingVolume& volume_;
  int first_slice_, made_, border_;
  BlockRows sheet_, flat_;
  float plateau_;
  std::vector<const float*> rows_, sheet_rows_;  // what is summed; the sheet's rows of the first slice, from below
  std::vector<std::uint8_t> kinds_;
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

GaussianBlur::GaussianBlur(double sigma) : weights_(gaussian_kernel(sigma)) {}

float GaussianBlur::plateau_after(float plateau) const {
  for (int axis = 0; axis < 3; ++axis) plateau = constant_sum(weights_, plateau);
  return plateau;
}

void GaussianBlur::blur_rows(const RollingVolume& volume, int first, int first_row, int end_row, RollingVolume& blurred,
                             const std::function<void(int, int)>& done) const {
  BandSums sums(weights_, volume, first, first_row);
  const int end = std::min(first + row_group, volume.frame().size[2]);
  for (int group = first_row; group < end_row; group += row_group) {
    sums.begin_rows(group);
    for (int k = first; k < end; ++k) {
      sums.sum_along_y(k - first);
      for (int j = group; j < std::min(group + row_group, end_row); ++j) {
        sums.sum_along_x(j - group, blurred.begin_row(j, k, sums.kinds()));
        blurred.end_row(j, k);
        done(j, k);
      }
    }
  }
}

}  // namespace homolog
