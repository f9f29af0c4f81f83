// SPDX-License-Identifier: MIT
#include "homolog/salient/growing_octave.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "homolog/base/parallel.h"

namespace homolog {
namespace {

constexpr int kPartRows = 96;  // of a level, about: so many that the sums along z which two parts share are few

// The most slices by which a volume is ahead of what is blurred from it, and how many of it are held for that.
int lead_before(const GaussianBlur& blur) { return (blur.radius() + 2 * row_group - 1) / row_group * row_group; }
int held_for_blur(const GaussianBlur& blur) { return lead_before(blur) + row_group + blur.radius(); }

}  // namespace

// What one thread does at a time: a band of rows of the next slices of a volume.
struct GrowingOctave::Part {
  std::size_t volume;
  int first_row, end_row;
};

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

// Whatever can grow from the slices that there are; the parts do not need each other.
std::vector<GrowingOctave::Part> GrowingOctave::next_parts() const {
  const int slices = octave_.frame().size[2], rows = octave_.frame().size[1];
  const int bands = std::max(1, (rows + kPartRows / 2) / kPartRows), groups = (rows + row_group - 1) / row_group;
  const int part_rows = (groups + bands - 1) / bands * row_group;
  std::vector<Part> parts;
  for (std::size_t i = made_.size(); i-- > 0;) {
    const int needed = i == 0 ? 0 : std::min(slices, made_[i] + row_group + blurs_[i - 1].radius());
    if (made_[i] == slices || (i > 0 && made_[i - 1] < needed)) continue;
    for (int row = 0; row < rows; row += part_rows) parts.push_back({i, row, std::min(rows, row + part_rows)});
  }
  return parts;
}

void GrowingOctave::grow_part(const Part& part, const MakeRow& make_coverage, const TakeRow& take_row) {
  RollingVolume& volume = volumes_[part.volume];
  const int first = made_[part.volume];
  if (part.volume == 0) {
    for (int k = first; k < std::min(octave_.frame().size[2], first + row_group); ++k) {
      for (int j = part.first_row; j < part.end_row; ++j) make_coverage(volume, j, k);
    }
    return;
  }
  const bool doubled = part.volume + 3 == volumes_.size();
  blurs_[part.volume - 1].blur_rows(volumes_[part.volume - 1], first, part.first_row, part.end_row, volume, [&](int j, int k) {
    if (doubled) take_row(volume, j, k);
  });
}

void GrowingOctave::grow(const MakeRow& make_coverage, const TakeRow& take_row, const std::function<void(const Octave&)>& visit) {
  const int slices = octave_.frame().size[2];
  while (octave_.end < slices) {
    const std::vector<Part> parts = next_parts();
    parallel_for(parts.size(), [&](std::size_t n) { grow_part(parts[n], make_coverage, take_row); });
    std::vector<bool> grown(made_.size());
    for (const Part& part : parts) grown[part.volume] = true;
    for (std::size_t i = 0; i < made_.size(); ++i) {
      if (grown[i]) made_[i] = std::min(slices, made_[i] + row_group);
    }
    octave_.first = octave_.end;
    octave_.end = made_.back() == slices ? slices : std::max(0, made_.back() - reach_);
    if (octave_.end > octave_.first) visit(octave_);
  }
}

}  // namespace homolog
