// SPDX-License-Identifier: MIT
#include "machine_floor.h"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <functional>
#include <vector>

#if defined(__x86_64__) && defined(__GNUC__)
#define HOMOLOG_BENCH_AVX2 __attribute__((target("avx2,fma")))
#else
#define HOMOLOG_BENCH_AVX2
#endif

namespace homolog::bench {
namespace {

constexpr int runs = 7;
constexpr double later_octaves = 1.0 / 8 + 1.0 / 64 + 1.0 / 512;  // voxels, of the first octave's

double best_seconds(const std::function<void()>& work) {
  double best = 1e9;
  for (int run = 0; run < runs; ++run) {
    const std::clock_t start = std::clock();
    work();
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

using Eight [[gnu::vector_size(32)]] = float;
constexpr int chains = 12;  // independent sums, enough to hide the latency of two units

// rounds x chains fused multiply-adds of 8.
HOMOLOG_BENCH_AVX2 float multiply_add(int rounds, float factor) {
  Eight sum[chains];
  const Eight a = Eight{} + factor, b = Eight{} + 1e-3f;
  for (int i = 0; i < chains; ++i) sum[i] = Eight{} + static_cast<float>(i);
  for (int round = 0; round < rounds; ++round) {
    for (int i = 0; i < chains; ++i) sum[i] = sum[i] * a + b;
  }
  float all = 0;
  for (int i = 0; i < chains; ++i) all += sum[i][0];
  return all;
}

}  // namespace

MachineFloor measure_floor() {
  MachineFloor floor;
  std::vector<char> from(256 << 20, 1), to(from.size(), 2);
  floor.copy_gb_per_s = 2e-9 * static_cast<double>(from.size()) / best_seconds([&] { std::memcpy(to.data(), from.data(), from.size()); });
  constexpr int rounds = 20'000'000;
  volatile float kept = 0, factor = 0.999f;
  floor.fma_gflop_per_s = 1e-9 * 2 * 8 * chains * rounds / best_seconds([&] { kept = multiply_add(rounds, factor); });
  return floor;
}

double scale_space_floor_ms(const MachineFloor& floor, double voxels) {
  return 1e-6 * 2 * (327 + 288 * later_octaves) * voxels / floor.fma_gflop_per_s;
}

double copy_floor_ms(const MachineFloor& floor, const std::string& stage, double voxels) {
  const double values = stage == "voxels"           ? 1
                        : stage == "salient points" ? 2 * 5 * (1 + later_octaves)
                        : stage == "descriptors"    ? 1 + 2 * later_octaves
                                                    : 0;
  return 1e-6 * sizeof(float) * values * voxels / floor.copy_gb_per_s;
}

}  // namespace homolog::bench
