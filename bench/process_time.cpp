// SPDX-License-Identifier: MIT
#include "process_time.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <tuple>

#include "homolog/base/errors.h"

extern char** environ;

namespace homolog::bench {
namespace {

double milliseconds(const timeval& time) { return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec); }

// Starts a program whose output goes into a pipe; the pipe's other end, and the process.
std::pair<std::FILE*, pid_t> start(std::vector<char*> words) {
  int ends[2];
  if (pipe(ends) != 0) throw Error("no pipe can be had");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  pid_t process = 0;
  const int failed = posix_spawnp(&process, words[0], &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (failed != 0) throw Error(fmt::format("{} cannot be started", words[0]));
  return {fdopen(ends[0], "r"), process};
}

ProcessTime measure_once(const std::vector<char*>& words) {
  const auto begin = std::chrono::steady_clock::now();
  const auto [output, process] = start(words);
  char line[256];
  std::ignore = std::fgets(line, sizeof line, output);
  ProcessTime time;
  time.first_line_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  while (std::fgets(line, sizeof line, output)) continue;
  std::fclose(output);
  rusage usage{};
  int status = 0;
  wait4(process, &status, 0, &usage);
  if (status != 0) throw Error(fmt::format("{} does not end well (status {})", words[0], status));
  time.cpu_ms = milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime);
  time.peak_mib = static_cast<double>(usage.ru_maxrss) / 1024;
  return time;
}

}  // namespace

ProcessTime measure_process(const std::vector<std::string>& command, int runs) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  constexpr double most = std::numeric_limits<double>::infinity();
  ProcessTime least{most, most, most};
  for (int run = 0; run < runs; ++run) {
    const ProcessTime time = measure_once(words);
    least.first_line_ms = std::min(least.first_line_ms, time.first_line_ms);
    least.cpu_ms = std::min(least.cpu_ms, time.cpu_ms);
    least.peak_mib = std::min(least.peak_mib, time.peak_mib);
  }
  return least;
}

}  // namespace homolog::bench
