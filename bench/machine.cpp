// SPDX-License-Identifier: MIT
#include "machine.h"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <thread>

namespace homolog::bench {
namespace {

// What /proc/cpuinfo says of the first core.
std::string core_fact(const std::string& name) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with(name) && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string commit() {
  std::FILE* git = popen("git -C \"" HOMOLOG_SOURCE_FOLDER "\" describe --always --dirty 2>/dev/null", "r");
  char text[64] = "";
  if (git) {
    if (!std::fgets(text, sizeof text, git)) text[0] = 0;
    pclose(git);
  }
  const std::string line(text);
  return line.empty() ? "unknown" : line.substr(0, line.find('\n'));
}

}  // namespace

std::string machine_and_commit() {
  return fmt::format("{}, {} cores, cache {}, at {}", core_fact("model name"), std::thread::hardware_concurrency(), core_fact("cache size"),
                     commit());
}

}  // namespace homolog::bench
