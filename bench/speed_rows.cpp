// SPDX-License-Identifier: MIT
#include "speed_rows.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "stage_times.h"

namespace homolog::bench {
namespace {

std::string ratio_text(double milliseconds, double floor) { return floor > 0 ? fmt::format("{:.2f}", milliseconds / floor) : ""; }

}  // namespace

void print_speed_header() {
  fmt::print("\n{:14} {:>5} {:>7}  {:20} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}  of\n", "shape", "grid", "threads", "stage", "ms", "CPU ms",
             "x floor", "x cube", "x copy", "peak MiB");
}

void print_speed_rows(const Measured& measured, const std::vector<Stage>& stages, const MachineFloor& floor) {
  double count = 0, cubes = 0;  // voxels, and how many they would be if shapes were cubes
  for (const Stage& stage : stages) {
    if (stage.name == "voxels") count += static_cast<double>(stage.count), cubes += std::pow(measured.grid, 3);
  }
  const auto row = [&](const Stage& stage, const std::string& of) {
    const bool salient = stage.name == "salient points";
    const auto over_arithmetic = [&](double voxels) {
      return ratio_text(stage.cpu_milliseconds, salient ? scale_space_floor_ms(floor, voxels) : 0);
    };
    fmt::print("{:14} {:5} {:>7}  {:20} {:9.1f} {:9.1f} {:>9} {:>9} {:>9} {:9.1f}  {}\n", measured.name, measured.grid,
               measured.threads == 0 ? "all" : std::to_string(measured.threads), stage.name, stage.milliseconds, stage.cpu_milliseconds,
               over_arithmetic(count), over_arithmetic(cubes), ratio_text(stage.cpu_milliseconds, copy_floor_ms(floor, stage.name, count)),
               static_cast<double>(stage.peak_bytes) / (1 << 20), of);
  };
  for (const Stage& stage : by_name(stages)) row(stage, fmt::format("{} {}", stage.count, stage.counted));
  row({"all", sum_of(stages, &Stage::milliseconds), sum_of(stages, &Stage::cpu_milliseconds), stages.back().peak_bytes, 0, ""}, "");
  std::fflush(stdout);
}

}  // namespace homolog::bench
