// SPDX-License-Identifier: MIT
// What this machine can do at best, one thread: the yardstick that times are compared with.
#pragma once

#include <string>

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

/// Least time in which memory as far as it must be read and written can be moved, for the stages of a shape of so many voxels that move
/// most: voxels are written once; each of the 5 Gaussians of 4 octaves is written and read once; for the descriptors all voxels are read
/// and halved until few are left. 0 for any other stage.
double copy_floor_ms(const MachineFloor& floor, const std::string& stage, double voxels);

}  // namespace homolog::bench
