// SPDX-License-Identifier: MIT
// The system counts what can be written to (RLIMIT_DATA), not what is reserved. Sanitizers have terabytes of that before anything else, so
// the limit by default is on what comes in addition.
#include "memory_limit.h"

#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "homolog/base/own_memory.h"

namespace homolog::cli {
namespace {

constexpr double kUsable = 0.95;  // the rest is for what the limit does not count but the system does, as tables of pages
constexpr std::uint64_t kUntold = std::numeric_limits<std::uint64_t>::max();

/// With what can be swapped out.
std::uint64_t free_on_machine() {
  std::ifstream info("/proc/meminfo");
  std::uint64_t sum = 0, kibibytes = 0;
  bool is_told = false;  // old systems tell only what of the swap is free
  for (std::string name, rest; info >> name >> kibibytes && std::getline(info, rest);) {
    is_told = is_told || name == "MemAvailable:";
    if (name == "MemAvailable:" || name == "SwapFree:") sum += kibibytes << 10;
  }
  return is_told ? sum : kUntold;
}

/// The least that the control groups around this process allow, of either version.
std::uint64_t allowed_in_container() {
  std::uint64_t least = kUntold;
  std::ifstream groups("/proc/self/cgroup");  // lines of number:controllers:path
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const bool unified = second == first + 1;
    if (!unified && line.substr(first, second - first).find("memory") == std::string::npos) continue;
    for (std::filesystem::path group = line.substr(second + 1); !group.empty(); group = group.parent_path()) {
      std::ifstream limit(unified ? "/sys/fs/cgroup" + group.string() + "/memory.max"
                                  : "/sys/fs/cgroup/memory" + group.string() + "/memory.limit_in_bytes");
      if (std::uint64_t bytes = 0; limit >> bytes) least = std::min(least, bytes);
      if (group == group.parent_path()) break;
    }
  }
  return least;
}

rlimit limit_now() {
  rlimit limit{};
  getrlimit(RLIMIT_DATA, &limit);
  return limit;
}

}  // namespace

void limit_memory_to_free() {
  const std::uint64_t most = std::min(free_on_machine(), allowed_in_container());
  if (most == kUntold) return;
  rlimit limit = limit_now();
  limit.rlim_cur =
      std::min(limit.rlim_cur, static_cast<rlim_t>(data_bytes() + static_cast<std::uint64_t>(kUsable * static_cast<double>(most))));
  setrlimit(RLIMIT_DATA, &limit);
}

void limit_memory(std::uint64_t mebibytes) {
  rlimit limit = limit_now();
  limit.rlim_cur = mebibytes == 0 ? limit.rlim_max : std::min<rlim_t>(limit.rlim_max, mebibytes << 20);
  setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace homolog::cli
