// SPDX-License-Identifier: MIT
#include "homolog/salient/row_sums.h"

#include <algorithm>
#include <cmath>

// Everything below is inlined into functions for wide registers, as a call from them to code for narrow ones costs a hundred cycles.
namespace homolog {
namespace {

// One of the processor's registers, also in memory.
template <int width>
using Register [[gnu::vector_size(4 * width), gnu::aligned(4), gnu::may_alias]] = float;

template <int width>
[[gnu::always_inline]] inline const Register<width>& at(const float* p) {
  return *reinterpret_cast<const Register<width>*>(p);
}
template <int width>
[[gnu::always_inline]] inline Register<width>& at(float* p) {
  return *reinterpret_cast<Register<width>*>(p);
}

// sum + weight * values, rounded once. CMakeLists.txt lets the compiler fuse it, where the processor can.
template <int width>
[[gnu::always_inline]] inline void multiply_add(float weight, const Register<width>& values, Register<width>& sum) {
#if defined(__x86_64__)
  if constexpr (width == 4) {
    for (int i = 0; i < width; ++i) sum[i] = std::fma(weight, values[i], sum[i]);
    return;
  }
#endif
  sum += weight * values;
}

// `sums` of `registers` each from x on, kept in registers; a row is loaded once for all of them. The first and the last rows belong to some
// of the sums only: loops of a known length, which the compiler unrolls. There are at least sums - 1 weights.
template <int width, int sums, int registers>
[[gnu::always_inline]] inline void weigh_tile(const float* const* rows, const float* weights, int count, int x, float* const* out) {
  Register<width> sum[sums][registers];
  for (auto& row : sum) std::fill(row, row + registers, Register<width>{});
  const auto add = [&](int t, int first, int end) __attribute__((always_inline)) {
    for (int i = 0; i < registers; ++i) {
      const Register<width>& values = at<width>(rows[t] + x + i * width);
      for (int n = first; n < end; ++n) multiply_add<width>(weights[t - n], values, sum[n][i]);
    }
  };
#pragma GCC unroll 8
  for (int t = 0; t < sums - 1; ++t) add(t, 0, t + 1);
  for (int t = sums - 1; t < count; ++t) add(t, 0, sums);
#pragma GCC unroll 8
  for (int t = 0; t < sums - 1; ++t) add(count + t, t + 1, sums);
  for (int n = 0; n < sums; ++n) {
    for (int i = 0; i < registers; ++i) at<width>(out[n] + x + i * width) = sum[n][i];
  }
}

template <int width>
[[gnu::always_inline]] inline void weigh_across_by(const float* const* rows, const RowWeights& weights, int begin, int end,
                                                   float* const* sums) {
  constexpr int half = row_group / 2;
  const int count = 2 * weights.radius() + 1;
  int x = begin;
  for (; x + 2 * width <= end; x += 2 * width) {
    weigh_tile<width, half, 2>(rows, weights.values(), count, x, sums);
    weigh_tile<width, half, 2>(rows + half, weights.values(), count, x, sums + half);
  }
  if (x == end) return;
  weigh_tile<width, half, 1>(rows, weights.values(), count, x, sums);
  weigh_tile<width, half, 1>(rows + half, weights.values(), count, x, sums + half);
}

// Takes what is nearly 0 or nearly the plateau for it.
template <int width>
[[gnu::always_inline]] inline void settle(float plateau, Register<width>& values) {
  const Register<width> zeros{};
  values = values < zeros + nearly_zero ? zeros : values > zeros + (plateau - nearly_plateau) ? zeros + plateau : values;
}

template <int width, int registers>
[[gnu::always_inline]] inline void weigh_piece(const float* row, const float* weights, int count, float plateau, float* out) {
  Register<width> sum[registers];
  std::fill(sum, sum + registers, Register<width>{});
  for (int t = 0; t < count; ++t) {
    for (int i = 0; i < registers; ++i) multiply_add<width>(weights[t], at<width>(row + t + i * width), sum[i]);
  }
  for (int i = 0; i < registers; ++i) {
    settle<width>(plateau, sum[i]);
    at<width>(out + i * width) = sum[i];
  }
}

template <int width>
[[gnu::always_inline]] inline void weigh_along_by(const float* row, const RowWeights& weights, float plateau, int begin, int end,
                                                  float* sums) {
  const int count = 2 * weights.radius() + 1;
  const float* first = row - weights.radius();
  int x = begin;
  for (; x + 4 * width <= end; x += 4 * width) weigh_piece<width, 4>(first + x, weights.values(), count, plateau, sums + x);
  for (; x < end; x += row_block) weigh_piece<width, row_block / width>(first + x, weights.values(), count, plateau, sums + x);
}

template <int width>
[[gnu::always_inline]] inline float largest_difference_by(const float* a, const float* b, float factor, int begin, int end) {
  Register<width> largest = factor * (at<width>(a + begin) - at<width>(b + begin));
  for (int x = begin + width; x < end; x += width) {
    const Register<width> more = factor * (at<width>(a + x) - at<width>(b + x));
    largest = more > largest ? more : largest;
  }
  float result = largest[0];
  for (int i = 1; i < width; ++i) result = std::max<float>(result, largest[i]);
  return result;
}

}  // namespace

// Defines a function as name_by<width> for the widest registers that the processor has.
#if defined(__x86_64__) && defined(__GNUC__)
#define HOMOLOG_AS_WIDE_AS_CAN_BE(result, name, parameters, arguments)                              \
  [[gnu::target("avx512f")]] static result name##_16 parameters { return name##_by<16> arguments; } \
  [[gnu::target("avx2,fma")]] static result name##_8 parameters { return name##_by<8> arguments; }  \
  result name parameters {                                                                          \
    if (__builtin_cpu_supports("avx512f")) return name##_16 arguments;                              \
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return name##_8 arguments; \
    return name##_by<4> arguments;                                                                  \
  }
#else
#define HOMOLOG_AS_WIDE_AS_CAN_BE(result, name, parameters, arguments) \
  result name parameters { return name##_by<4> arguments; }
#endif

HOMOLOG_AS_WIDE_AS_CAN_BE(void, weigh_across, (const float* const* rows, const RowWeights& weights, int begin, int end, float* const* sums),
                          (rows, weights, begin, end, sums))
HOMOLOG_AS_WIDE_AS_CAN_BE(void, weigh_along, (const float* row, const RowWeights& weights, float plateau, int begin, int end, float* sums),
                          (row, weights, plateau, begin, end, sums))
HOMOLOG_AS_WIDE_AS_CAN_BE(float, largest_difference, (const float* a, const float* b, float factor, int begin, int end),
                          (a, b, factor, begin, end))

RowWeights::RowWeights(const std::vector<float>& half)
    : radius_(static_cast<int>(half.size()) - 1), padded_(2 * half.size() - 1 + 2 * row_group) {
  for (int t = -radius_; t <= radius_; ++t) padded_[row_group + radius_ + t] = half[std::abs(t)];
}

}  // namespace homolog
