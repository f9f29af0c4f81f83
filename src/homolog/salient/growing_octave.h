// SPDX-License-Identifier: MIT
// Sec. 4.3: all levels of one octave grow together, a few slices at a time: each is blurred from the one below as soon as that has the
// slices for it. So memory is needed for a share of the slices only.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "homolog/salient/gaussian_blur.h"
#include "homolog/salient/scale_space.h"

namespace homolog {

class GrowingOctave {
 public:
  /// An octave on `frame`, whose lowest level is blurred by params.sigma0 voxels: `lowest`, made whole, or else made from coverage by and
  /// by. Slices stay while one within `reach` is new.
  GrowingOctave(const GridFrame& frame, const SalientParams& params, int reach, std::optional<RollingVolume> lowest);

  /// Writes row (j, k) of the coverage.
  using MakeRow = std::function<void(RollingVolume& coverage, int j, int k)>;
  /// Called for every row (j, k) of the level with twice the lowest's blur, from which the next octave is made.
  using TakeRow = std::function<void(const RollingVolume& level, int j, int k)>;

  /// Grows to the end; calls visit(octave) whenever slices are new.
  void grow(const MakeRow& make_coverage, const TakeRow& take_row, const std::function<void(const Octave&)>& visit);

  /// The plateau of the level with twice the lowest's blur.
  float doubled_plateau() const { return volumes_[volumes_.size() - 3].plateau(); }

 private:
  void add_volume(std::size_t i);
  bool can_grow(std::size_t i) const;
  void grow_band(std::size_t i, int first_row, int end_row, const MakeRow& make_coverage, const TakeRow& take_row);

  std::vector<GaussianBlur> blurs_;     // blurs_[i] makes volume i + 1 from volume i
  std::vector<RollingVolume> volumes_;  // coverage, if the lowest level is made from it, and all levels
  std::vector<int> made_;               // slices of every volume
  Octave octave_;
  int reach_;
};

}  // namespace homolog
