// SPDX-License-Identifier: MIT
// What a program takes, as a process of its own.
#pragma once

#include <string>
#include <vector>

namespace homolog::bench {

struct ProcessTime {
  double first_line_ms = 0;  ///< by the clock on the wall, until the first line has arrived, or the end where it prints nothing
  double cpu_ms = 0;         ///< of the whole process
  double peak_mib = 0;
};

/// The least of several runs of a program, of which what it prints is thrown away. Throws Error if it does not end with exit code 0.
ProcessTime measure_process(const std::vector<std::string>& command, int runs);

}  // namespace homolog::bench
