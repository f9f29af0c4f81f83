// SPDX-License-Identifier: MIT
// The only door to threads (task_pool.h). Loops write to their own slot, so results do not depend on the number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace homolog {

/// Calls body(i) for every i in [0, count), in any order and on any thread. Exceptions reach the caller.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

/// While it lives, `check` is called between the bodies that the thread which made it runs itself; it stops the work by throwing.
class Checkpoint {
 public:
  explicit Checkpoint(std::function<void()> check);
  ~Checkpoint();
  Checkpoint(const Checkpoint&) = delete;
  Checkpoint& operator=(const Checkpoint&) = delete;

 private:
  std::function<void()> check_;
  const std::function<void()>* outer_;
};

/// While it lives, at most `threads` threads work (0: all cores).
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  std::shared_ptr<void> control_;
};

}  // namespace homolog
