// SPDX-License-Identifier: MIT
// While the library works, other Python threads may, too, and Ctrl-C stops it.
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>

#include "homolog/base/parallel.h"

namespace homolog::python {

/// While it lives, this thread does not hold the GIL, and Python's signal handlers run between the bodies of its parallel loops. What
/// they raise, KeyboardInterrupt first of all, ends the work.
class Interruptible {
  using Clock = std::chrono::steady_clock;

  static void check_signals() {
    const nanobind::gil_scoped_acquire hold;
    if (PyErr_CheckSignals() != 0) throw nanobind::python_error();
  }

  nanobind::gil_scoped_release free_;
  Clock::time_point last_ = Clock::now();
  Checkpoint checkpoint_{[this] {
    if (Clock::now() - last_ < std::chrono::milliseconds(50)) return;
    last_ = Clock::now();
    check_signals();
  }};
};

}  // namespace homolog::python
