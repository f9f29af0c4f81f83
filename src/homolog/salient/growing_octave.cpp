// SPDX-License-Identifier: MIT
#include "homolog/salient/growing_octave.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "homolog/base/parallel.h"

namespace homolog {
namespace {

constexpr int kBandRows = 64;  // what one thread does at a time, about: so many that the sums along z which two bands share are few

// The most slices by which a volume is ahead of what is blurred from it after a round, and how many of it are held for that.
int lead_before(const GaussianBlur& blur) { return (blur.radius() + row_group - 1) / row_group * row_group; }
int held_for_blur(const GaussianBlur& blur) { return lead_before(blur) + row_group + blur.radius(); }

}  // namespace

GrowingOctave::GrowingOctave(const GridFrame& frame, const SalientParams& params, int reach, std::optional<RollingVolume> lowest)
    : reach_(reach) {
  const double k = std::pow(2, 1.0 / params.levels_per_octave), sigma0 = params.sigma0;
  octave_.factor = static_cast<float>(-1 / (std::log(k) * ball_response(k)));  // Sec. 4.3 with the divisor ln k instead of k
  if (!lowest) blurs_.emplace_back(std::sqrt(std::max(sigma0 * sigma0 - coverage_variance, 0.25)));
  for (int i = 0; i < params.levels_per_octave + 2; ++i) {
    const double sigma = sigma0 * std::pow(k, i);
    octave_.sigmas.push_back(sigma * std::sqrt(k) * frame.spacing);
    blurs_.emplace_back(sigma * std::sqrt(k * k - 1));
  }
  made_.assign(blurs_.size() + 1, 0);
  if (lowest) {
    made_[0] = frame.size[2];
    volumes_.push_back(std::move(*lowest));
  } else {
    volumes_.emplace_back(frame, held_for_blur(blurs_[0]), 1.0f);
  }
  for (std::size_t i = 0; i < blurs_.size(); ++i) add_volume(i);
  octave_.blurred = std::span(volumes_).last(params.levels_per_octave + 3);
}

// The volume that blurs_[i] makes.
void GrowingOctave::add_volume(std::size_t i) {
  int ahead = 0;  // slices by which it may be ahead of the last one
  for (std::size_t above = i + 1; above < blurs_.size(); ++above) ahead += lead_before(blurs_[above]);
  const int for_blur = i + 1 < blurs_.size() ? held_for_blur(blurs_[i + 1]) : 0;
  volumes_.emplace_back(volumes_[i].frame(), std::max(for_blur, ahead + 2 * reach_ + row_group),
                        blurs_[i].plateau_after(volumes_[i].plateau()));
}

bool GrowingOctave::can_grow(std::size_t i) const {
  const int slices = octave_.frame().size[2];
  return made_[i] < slices && (i == 0 || made_[i - 1] >= std::min(slices, made_[i] + row_group + blurs_[i - 1].radius()));
}

// Makes the rows first_row <= j < end_row of the next slices of a volume.
void GrowingOctave::grow_band(std::size_t i, int first_row, int end_row, const MakeRow& make_coverage, const TakeRow& take_row) {
  RollingVolume& volume = volumes_[i];
  if (i == 0) {
    for (int k = made_[0]; k < std::min(octave_.frame().size[2], made_[0] + row_group); ++k) {
      for (int j = first_row; j < end_row; ++j) make_coverage(volume, j, k);
    }
    return;
  }
  const bool doubled = i + 3 == volumes_.size();
  blurs_[i - 1].blur_rows(volumes_[i - 1], made_[i], first_row, end_row, volume, [&](int j, int k) {
    if (doubled) take_row(volume, j, k);
  });
}

void GrowingOctave::grow(const MakeRow& make_coverage, const TakeRow& take_row, const std::function<void(const Octave&)>& visit) {
  const int slices = octave_.frame().size[2], rows = octave_.frame().size[1];
  const int groups = (rows + row_group - 1) / row_group, bands = (rows + kBandRows - 1) / kBandRows;
  const auto band_begin = [&](std::size_t band) { return std::min(rows, static_cast<int>(band) * groups / bands * row_group); };
  while (octave_.end < slices) {
    for (std::size_t i = 0; i < volumes_.size(); ++i) {
      if (!can_grow(i)) continue;
      parallel_for(bands, [&](std::size_t n) { grow_band(i, band_begin(n), band_begin(n + 1), make_coverage, take_row); });
      made_[i] = std::min(slices, made_[i] + row_group);
    }
    octave_.first = octave_.end;
    octave_.end = made_.back() == slices ? slices : std::max(0, made_.back() - reach_);
    if (octave_.end > octave_.first) visit(octave_);
  }
}

}  // namespace homolog
