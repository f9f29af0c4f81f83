// SPDX-License-Identifier: MIT
// Sec. 6.2.3. One pass per axis, the second and third by the lower envelope of parabolas (Felzenszwalb & Huttenlocher 2012), on
// squared distances in voxels, which are whole numbers and therefore exact; the square root comes last.
#include "homolog/shape/distance_transform.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "homolog/base/parallel.h"

namespace homolog {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/// The lower envelope of the parabolas f(p) + (q - p)^2 over a line of voxels q.
struct Envelope {
  std::vector<float> values;   // f, the line before the pass
  std::vector<int> apex;       // p of the parabolas in the envelope, left to right
  std::vector<double> lifted;  // their f(p) + p^2
  std::vector<double> from;    // where each of them starts to be the lowest
  std::vector<double> half;    // 1 / 2d for every distance d: a table instead of a division, as errors of rounding cannot matter
                               // (different meeting places differ by 1 / 4d^2 at least)
  explicit Envelope(int length) : values(length), apex(length), lifted(length), from(length), half(length) {
    for (int d = 1; d < length; ++d) half[d] = 0.5 / d;
  }
};

int build_envelope(Envelope& line) {
  int count = 0;
  for (int q = 0; q < static_cast<int>(line.values.size()); ++q) {
    if (line.values[q] == infinite) continue;
    const double lifted = line.values[q] + static_cast<double>(q) * q;
    double from = -infinite;
    while (count > 0) {
      from = (lifted - line.lifted[count - 1]) * line.half[q - line.apex[count - 1]];
      if (from > line.from[count - 1]) break;
      --count;
      from = -infinite;
    }
    line.apex[count] = q;
    line.lifted[count] = lifted;
    line.from[count++] = from;
  }
  return count;
}

void transform_line(Envelope& line, float* values, std::size_t stride) {
  const int length = static_cast<int>(line.values.size());
  for (int q = 0; q < length; ++q) line.values[q] = values[q * stride];
  const int count = build_envelope(line);
  if (count == 0) return;
  for (int q = 0, k = 0; q < length; ++q) {
    while (k + 1 < count && line.from[k + 1] < q) ++k;
    const float offset = static_cast<float>(q - line.apex[k]);
    values[q * stride] = offset * offset + line.values[line.apex[k]];
  }
}

/// The first pass: squared distances to the nearest inside of the same line, by a sweep forth and one back.
void measure_along_x(const Interior& interior, Volume<float>& squared) {
  const std::size_t length = interior.frame.size[0];
  parallel_for(static_cast<std::size_t>(interior.frame.size[1]) * interior.frame.size[2], [&](std::size_t line) {
    const float* coverage = interior.values.data() + line * length;
    float* values = squared.values.data() + line * length;
    float steps = infinite;
    for (std::size_t i = 0; i < length; ++i) values[i] = steps = coverage[i] >= 0.5f ? 0 : steps + 1;
    for (std::size_t i = length; i-- > 0;) {
      steps = std::min(values[i], steps + 1);
      values[i] = steps * steps;
    }
  });
}

/// A further pass, along y or z; a task is a whole slab of lines, so that its scratch is allocated once.
void transform_axis(Volume<float>& squared, int axis) {
  const auto& n = squared.frame.size;
  const std::size_t strides[3] = {1, static_cast<std::size_t>(n[0]), static_cast<std::size_t>(n[0]) * n[1]};
  const int outer = axis == 1 ? 2 : 1;
  parallel_for(n[outer], [&](std::size_t slab) {
    Envelope line(n[axis]);
    float* values = squared.values.data() + slab * strides[outer];
    for (int i = 0; i < n[0]; ++i) transform_line(line, values + i, strides[axis]);
  });
}

}  // namespace

Volume<float> distance_transform(const Interior& interior) {
  Volume<float> distance{interior.frame, std::vector<float>(interior.values.size())};
  measure_along_x(interior, distance);
  for (int axis = 1; axis < 3; ++axis) transform_axis(distance, axis);
  const auto spacing = static_cast<float>(interior.frame.spacing);
  for (float& value : distance.values) value = spacing * std::sqrt(value);
  return distance;
}

}  // namespace homolog
