// SPDX-License-Identifier: MIT
// How long a program takes from its start to its first line.
#pragma once

#include <string>
#include <vector>

namespace homolog::bench {

struct StartTime {
  double first_line_ms = 0;  ///< by the clock on the wall, until the first line has arrived
  double cpu_ms = 0;         ///< of the whole process
};

/// The least of several runs of a program, of which what it prints is thrown away.
StartTime measure_start(const std::vector<std::string>& command, int runs);

}  // namespace homolog::bench
