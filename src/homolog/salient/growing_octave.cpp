// SPDX-License-Identifier: MIT
#include "homolog/salient/growing_octave.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace homolog {

GrowingOctave::GrowingOctave(const GridFrame& frame, const SalientParams& params, int reach)
    : top_(frame, growth_step), made_(params.levels_per_octave + 3), reach_(reach) {
  const double k = std::pow(2, 1.0 / params.levels_per_octave);
  factor_ = static_cast<float>(-1 / (std::log(k) * ball_response(k)));  // Sec. 4.3 with the divisor ln k instead of k
  int lag = 0;                                                          // slices by which a level may be ahead of the last one
  for (int i = 0; i < params.levels_per_octave + 2; ++i) {
    const double sigma = params.sigma0 * std::pow(k, i);
    octave_.sigmas.push_back(sigma * std::sqrt(k) * frame.spacing);
    blurs_.emplace_back(frame, sigma * std::sqrt(k * k - 1), growth_step);
    lag += blurs_.back().radius();
  }
  for (const RollingBlur& blur : blurs_) {
    octave_.levels.emplace_back(frame, lag + growth_step + 2 * reach);
    lag -= blur.radius();
  }
}

void GrowingOctave::begin_with(RollingVolume lowest) {
  made_[0] = lowest.frame().size[2];
  octave_.levels[0] = std::move(lowest);
}

void GrowingOctave::grow_above(std::size_t i, const TakeRow& take_row) {
  RollingVolume &level = octave_.levels[i], &above = i + 1 < octave_.levels.size() ? octave_.levels[i + 1] : top_;
  blurs_[i].take(level, std::min(made_[i], blurs_[i].taken() + growth_step));
  const int end = std::min(blurs_[i].ready(), made_[i + 1] + growth_step);
  const bool doubled = i + 4 == made_.size();
  blurs_[i].give(made_[i + 1], end, above, [&](int j, int k) {
    if (doubled) take_row(above, j, k);
    const Run& run = above.run(j, k);
    subtract_row(above.row(j, k), factor_, block_begin(run), block_end(run), level.change_row(j, k, run));
  });
  made_[i + 1] = end;
}

void GrowingOctave::grow(const MakeSlices& make_lowest, const TakeRow& take_row, const std::function<void(const Octave&)>& visit) {
  const int slices = top_.frame().size[2];
  while (octave_.end < slices) {
    if (made_[0] < slices) made_[0] = make_lowest(made_[0], octave_.levels[0]);
    for (std::size_t i = 0; i < blurs_.size(); ++i) grow_above(i, take_row);
    octave_.first = octave_.end;
    octave_.end = made_.back() == slices ? slices : std::max(0, made_.back() - reach_);
    if (octave_.end > octave_.first) visit(octave_);
  }
}

}  // namespace homolog
