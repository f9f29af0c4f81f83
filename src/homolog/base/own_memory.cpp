// SPDX-License-Identifier: MIT
#include "homolog/base/own_memory.h"

#include <unistd.h>

#include <fstream>

namespace homolog {

std::uint64_t data_bytes() {
  std::ifstream statm("/proc/self/statm");
  std::uint64_t pages = 0;
  for (int field = 0; field < 6; ++field) statm >> pages;
  return statm ? pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace homolog
