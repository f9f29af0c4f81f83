// SPDX-License-Identifier: MIT
#include "homolog/base/stopwatch.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <ctime>

namespace homolog {
namespace {

std::string table_row(const std::string& name, double milliseconds, double cpu_milliseconds, std::size_t peak_bytes) {
  return fmt::format("{:28} {:10.1f} {:10.1f} {:10.1f}", name, milliseconds, cpu_milliseconds, static_cast<double>(peak_bytes) / (1 << 20));
}

/// Scenes are read in a child (shape/read_in_child.h), whose time counts once it has ended.
double cpu_milliseconds() {
  rusage children{};
  getrusage(RUSAGE_CHILDREN, &children);
  const auto of = [](const timeval& time) { return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec); };
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC + of(children.ru_utime) + of(children.ru_stime);
}

}  // namespace

Stopwatch::Stopwatch() : wall_(std::chrono::steady_clock::now()), cpu_milliseconds_(cpu_milliseconds()) {}

void Stopwatch::lap(const std::string& name, std::size_t count, const std::string& counted) {
  const auto wall = std::chrono::steady_clock::now();
  const double cpu = cpu_milliseconds();
  const double milliseconds = std::chrono::duration<double, std::milli>(wall - wall_).count();
  stages_.push_back({name, milliseconds, cpu - cpu_milliseconds_, peak_memory(), count, counted});
  wall_ = wall;
  cpu_milliseconds_ = cpu;
}

std::size_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto peak = static_cast<std::size_t>(usage.ru_maxrss);
#ifdef __APPLE__
  return peak;
#else
  return 1024 * peak;
#endif
}

void lap(Stopwatch* watch, const std::string& name, std::size_t count, const std::string& counted) {
  if (watch) watch->lap(name, count, counted);
}

std::string timing_table(const std::vector<Stage>& stages) {
  std::string table = fmt::format("{:28} {:>10} {:>10} {:>10}  of\n", "stage", "ms", "CPU ms", "peak MiB");
  Stage all{"all", 0, 0, 0, 0, ""};
  for (const Stage& stage : stages) {
    table += table_row(stage.name, stage.milliseconds, stage.cpu_milliseconds, stage.peak_bytes);
    table += fmt::format("  {} {}\n", stage.count, stage.counted);
    all.milliseconds += stage.milliseconds;
    all.cpu_milliseconds += stage.cpu_milliseconds;
    all.peak_bytes = std::max(all.peak_bytes, stage.peak_bytes);
  }
  return table + table_row(all.name, all.milliseconds, all.cpu_milliseconds, all.peak_bytes) + "\n";
}

}  // namespace homolog
