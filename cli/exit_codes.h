// SPDX-License-Identifier: MIT
// What the program's exit codes mean, and the error of wrong usage.
#pragma once

#include <stdexcept>

namespace homolog::cli {

enum ExitCode { kFound = 0, kNothingFound = 1, kWrongUsage = 2, kUnusableShape = 3, kNotWritten = 4 };

/// The command line is wrong; what() is one sentence for the user.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace homolog::cli
