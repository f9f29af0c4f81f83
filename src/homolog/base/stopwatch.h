// SPDX-License-Identifier: MIT
// Where the time goes: laps of wall clock, processor time and memory, taken by whoever hands a stopwatch to the pipeline.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace homolog {

/// One lap. What it made is counted so that costs can be told per piece.
struct Stage {
  std::string name;
  double milliseconds = 0;      ///< by the clock on the wall
  double cpu_milliseconds = 0;  ///< of all threads of the process together, and of its children that have ended
  std::size_t peak_bytes = 0;   ///< the most memory that the process has held so far
  std::size_t count = 0;
  std::string counted;  ///< of what: "voxels"
};

class Stopwatch {
 public:
  Stopwatch();

  /// Ends a lap, which began with the one before.
  void lap(const std::string& name, std::size_t count, const std::string& counted);

  const std::vector<Stage>& stages() const { return stages_; }

 private:
  std::chrono::steady_clock::time_point wall_;
  double cpu_milliseconds_;
  std::vector<Stage> stages_;
};

/// The most memory that this process has held in RAM, in bytes.
std::size_t peak_memory();

/// Ends a lap if anyone watches.
void lap(Stopwatch* watch, const std::string& name, std::size_t count, const std::string& counted);

/// The stages as a table, one line each, and their sum.
std::string timing_table(const std::vector<Stage>& stages);

}  // namespace homolog
