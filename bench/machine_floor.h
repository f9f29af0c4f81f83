// SPDX-License-Identifier: MIT
// What this machine can do at best, one thread: the yardstick that times are compared with.
#pragma once

namespace homolog::bench {

struct MachineFloor {
  double copy_gb_per_s = 0;    ///< copying memory far larger than the caches, bytes read plus bytes written
  double fma_gflop_per_s = 0;  ///< fused multiply-adds of single precision in registers of 8, two operations each
};

/// The best of several short runs, by processor time.
MachineFloor measure_floor();

/// Least time of a dense scale space of n^3 voxels: 4 octaves of 5 Gaussians of 13, 13, 19, 27 and 37 taps, axis by axis, which are 327
/// multiply-adds a voxel in the first octave and 288 in the later ones (the pyramid that scipy and ITK are measured with, too).
double scale_space_floor_ms(const MachineFloor& floor, double voxels);

}  // namespace homolog::bench
