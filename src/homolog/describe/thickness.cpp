// SPDX-License-Identifier: MIT
#include "homolog/describe/thickness.h"

#include <algorithm>

#include "homolog/base/parallel.h"

namespace homolog {

std::vector<double> thickness_at(const Interior& interior, const std::vector<SurfaceSample>& samples) {
  const auto& size = interior.frame.size;
  const int longest = 2 * (size[0] + size[1] + size[2]);
  std::vector<double> thickness(samples.size());
  parallel_for(samples.size(), [&](std::size_t i) {
    const Vec3 step = -0.5 * interior.frame.spacing * samples[i].normal;
    int steps = 3;  // the skin itself is a voxel wide
    while (steps < longest && sample(interior, samples[i].position + steps * step) > 0.5f) ++steps;
    thickness[i] = steps * step.norm();
  });
  return thickness;
}

}  // namespace homolog
