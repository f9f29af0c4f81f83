// SPDX-License-Identifier: MIT
#include "stage_times.h"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace homolog::bench {
namespace {

// Lets peak_memory() begin anew, where the system can.
void forget_peak() {
  malloc_trim(0);
  if (std::FILE* file = std::fopen("/proc/self/clear_refs", "w")) {
    std::fputs("5", file);
    std::fclose(file);
  }
}

constexpr double least_milliseconds = 1;  // what takes less tells nothing of growth

// Slope of log time against log size.
double exponent(const std::vector<std::pair<double, double>>& times) {
  double x = 0, y = 0, xx = 0, xy = 0;
  const auto n = static_cast<double>(times.size());
  for (const auto& [size, time] : times) {
    const double log_size = std::log(size), log_time = std::log(time);
    x += log_size, y += log_time, xx += log_size * log_size, xy += log_size * log_time;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace

std::vector<Stage> best_stages(int repeats, const std::function<void(Stopwatch&)>& work) {
  std::vector<Stage> best;
  for (int run = 0; run < repeats; ++run) {
    forget_peak();
    Stopwatch watch;
    work(watch);
    if (best.empty()) best = watch.stages();
    for (std::size_t i = 0; i < best.size(); ++i) {
      best[i].milliseconds = std::min(best[i].milliseconds, watch.stages()[i].milliseconds);
      best[i].cpu_milliseconds = std::min(best[i].cpu_milliseconds, watch.stages()[i].cpu_milliseconds);
      best[i].peak_bytes = std::min(best[i].peak_bytes, watch.stages()[i].peak_bytes);
    }
  }
  return best;
}

std::vector<Stage> by_name(const std::vector<Stage>& stages) {
  std::vector<Stage> named;
  for (const Stage& stage : stages) {
    const auto same = std::find_if(named.begin(), named.end(), [&](const Stage& other) { return other.name == stage.name; });
    if (same == named.end()) {
      named.push_back(stage);
      continue;
    }
    same->milliseconds += stage.milliseconds;
    same->cpu_milliseconds += stage.cpu_milliseconds;
    same->peak_bytes = std::max(same->peak_bytes, stage.peak_bytes);
    same->count += stage.count;
  }
  return named;
}

double sum_of(const std::vector<Stage>& stages, double Stage::*what) {
  double sum = 0;
  for (const Stage& stage : stages) sum += stage.*what;
  return sum;
}

void add_times(Growth& growth, double size, const std::vector<Stage>& stages) {
  for (const Stage& stage : stages) growth[stage.name].emplace_back(size, stage.cpu_milliseconds);
  growth["all"].emplace_back(size, sum_of(stages, &Stage::cpu_milliseconds));
}

std::string told_exponents(const Growth& growth, const std::string& symbol) {
  std::string text;
  for (auto [stage, times] : growth) {
    std::erase_if(times, [](const auto& time) { return time.second < least_milliseconds; });
    const auto differs = [&](const auto& time) { return time.first != times.front().first; };
    if (std::any_of(times.begin(), times.end(), differs)) text += fmt::format("  {} {}^{:.1f}", stage, symbol, exponent(times));
  }
  return text;
}

}  // namespace homolog::bench
