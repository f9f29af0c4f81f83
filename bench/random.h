// SPDX-License-Identifier: MIT
// Random numbers that are the same on every system (SplitMix64; the standard library's distributions are not).
#pragma once

#include <cstdint>
#include <string>

#include "homolog/base/vec.h"

namespace homolog::bench {

class Random {
 public:
  Random(std::uint64_t seed, const std::string& name);

  double unit();  ///< evenly in [0, 1)
  double between(double low, double high) { return low + (high - low) * unit(); }
  double normal();   ///< mean 0, variance 1
  Vec3 direction();  ///< unit length, evenly
  Mat3 rotation();   ///< evenly

 private:
  std::uint64_t state_;
};

}  // namespace homolog::bench
