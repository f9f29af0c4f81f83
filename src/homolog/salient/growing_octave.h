// SPDX-License-Identifier: MIT
// Sec. 4.3: all levels of one octave grow together, a few slices at a time: each is blurred from the one below as soon as that has the
// slices for it, and becomes a difference as soon as the one above is there. So every sum finds its input in the cache, and memory
// is needed for a share of the slices only.
#pragma once

#include <functional>
#include <vector>

#include "homolog/salient/gaussian_blur.h"
#include "homolog/salient/scale_space.h"

namespace homolog {

/// Slices by which a level grows at a time: few enough for the cache, enough for several threads.
inline constexpr int growth_step = 8;

class GrowingOctave {
 public:
  /// An octave on `frame`, whose lowest level is blurred by params.sigma0 voxels. Slices stay while one within `reach` is new.
  GrowingOctave(const GridFrame& frame, const SalientParams& params, int reach);

  /// Takes the lowest level, made whole, instead of having it made by and by.
  void begin_with(RollingVolume lowest);

  /// Called once more slices of the lowest level are wanted: gets how many there are, returns how many there are now (up to growth_step
  /// more).
  using MakeSlices = std::function<int(int made, RollingVolume& lowest)>;
  /// Called for every row (j, k) of the level with twice the lowest's blur, from which the next octave is made.
  using TakeRow = std::function<void(const RollingVolume& level, int j, int k)>;

  /// Grows to the end; calls visit(octave) whenever slices are new.
  void grow(const MakeSlices& make_lowest, const TakeRow& take_row, const std::function<void(const Octave&)>& visit);

 private:
  void grow_above(std::size_t i, const TakeRow& take_row);

  Octave octave_;                   // levels[i] holds G(s_i), slice by slice replaced by the difference
  RollingVolume top_;               // the last G, of which there is no difference
  std::vector<RollingBlur> blurs_;  // blurs_[i] makes level i + 1 from level i
  std::vector<int> made_;           // slices of every level and the top
  float factor_;
  int reach_;
};

}  // namespace homolog
