// SPDX-License-Identifier: MIT
// Talking to the user: results on stdout, progress and warnings on stderr, progress only if that is a terminal.
#pragma once

#include <string>
#include <string_view>

namespace homolog::cli {

/// Writes a result to stdout. Throws OutputError when that fails (a full disk, for example).
void print_result(std::string_view text);

/// One line `homolog: sentence` on stderr.
void print_message(std::string_view sentence);

/// Progress and warnings; silent when quiet.
class Console {
 public:
  explicit Console(bool quiet);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// What the program does now; replaces the stage shown before.
  void stage(std::string_view text);
  void warn(std::string_view sentence);
  /// Takes the progress line away; call before printing results.
  void clear();

 private:
  bool quiet_, progress_, shown_ = false;
};

}  // namespace homolog::cli
