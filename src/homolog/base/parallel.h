// SPDX-License-Identifier: MIT
// The only door to threads (oneTBB inside). Loops write to their own slot, so results do not depend on the number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace homolog {

/// Calls body(i) for every i in [0, count), in any order and on any thread. Exceptions reach the caller.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

/// While it lives, at most `threads` threads work (0: all cores).
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace homolog
