// SPDX-License-Identifier: MIT
// Talking to the user: results on stdout, progress and warnings on stderr, progress only if that is a terminal.
#pragma once

#include <string>
#include <string_view>

#include "homolog/base/stopwatch.h"
#include "homolog/shape/tell.h"

namespace homolog::cli {

/// Writes a result to stdout, without commands for the terminal. Throws OutputError when that fails (a full disk, for example).
void print_result(std::string_view text);

/// One line `homolog: sentence` on stderr, whatever the names in it hold.
void print_message(std::string_view sentence);

/// Progress and warnings, silent when quiet; and what each stage took, told at the end when wanted.
class Console {
 public:
  Console(bool quiet, bool timing);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// What the program does now; replaces the stage shown before.
  void stage(std::string_view text);
  void warn(std::string_view sentence);
  /// Takes the progress line away; call before printing results.
  void clear();
  Stopwatch& watch() { return watch_; }

 private:
  bool quiet_, timing_, progress_, shown_ = false;
  Stopwatch watch_;
};

/// What is told while a file is read becomes warnings that name it.
Tell warnings_of(const std::string& path, Console& console);

}  // namespace homolog::cli
