// SPDX-License-Identifier: MIT
// Sec. 6.2.3. Three passes of the one-dimensional lower envelope of parabolas (Felzenszwalb & Huttenlocher 2012), on squared
// distances in voxels, which are whole numbers and therefore exact; the square root comes last.
#include "homolog/shape/distance_transform.h"

#include <cmath>
#include <limits>

#include "homolog/base/parallel.h"

namespace homolog {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

struct Envelope {
  std::vector<float> values;  // the line before the pass
  std::vector<int> apex;      // parabolas of the envelope, left to right
  std::vector<double> from;   // where each of them starts to be the lowest
  explicit Envelope(int length) : values(length), apex(length), from(length) {}
};

/// Where the parabola with apex at q starts to lie below the one with apex at p < q.
double meeting(const std::vector<float>& f, int p, int q) {
  return ((static_cast<double>(f[q]) + static_cast<double>(q) * q) - (static_cast<double>(f[p]) + static_cast<double>(p) * p)) /
         (2.0 * (q - p));
}

void transform_line(Envelope& line, float* values, std::size_t stride) {
  const int length = static_cast<int>(line.values.size());
  for (int q = 0; q < length; ++q) line.values[q] = values[q * stride];
  int count = 0;
  for (int q = 0; q < length; ++q) {
    if (line.values[q] == infinite) continue;
    double from = -infinite;
    while (count > 0) {
      from = meeting(line.values, line.apex[count - 1], q);
      if (from > line.from[count - 1]) break;
      --count;
      from = -infinite;
    }
    line.apex[count] = q;
    line.from[count++] = from;
  }
  if (count == 0) return;
  for (int q = 0, k = 0; q < length; ++q) {
    while (k + 1 < count && line.from[k + 1] < q) ++k;
    const float offset = static_cast<float>(q - line.apex[k]);
    values[q * stride] = offset * offset + line.values[line.apex[k]];
  }
}

/// One pass along `axis`; a task is a whole slab of lines, so that its scratch is allocated once.
void transform_axis(Volume<float>& squared, int axis) {
  const auto& n = squared.frame.size;
  const std::size_t strides[3] = {1, static_cast<std::size_t>(n[0]), static_cast<std::size_t>(n[0]) * n[1]};
  const int inner = axis == 0 ? 1 : 0, outer = axis == 2 ? 1 : 2;
  parallel_for(n[outer], [&](std::size_t slab) {
    Envelope line(n[axis]);
    float* values = squared.values.data() + slab * strides[outer];
    for (int i = 0; i < n[inner]; ++i) transform_line(line, values + i * strides[inner], strides[axis]);
  });
}

}  // namespace

Volume<float> distance_transform(const Interior& interior) {
  Volume<float> distance{interior.frame, std::vector<float>(interior.values.size())};
  for (std::size_t i = 0; i < interior.values.size(); ++i) distance.values[i] = interior.values[i] >= 0.5f ? 0 : infinite;
  for (int axis = 0; axis < 3; ++axis) transform_axis(distance, axis);
  for (float& value : distance.values) value = static_cast<float>(interior.frame.spacing * std::sqrt(static_cast<double>(value)));
  return distance;
}

}  // namespace homolog
