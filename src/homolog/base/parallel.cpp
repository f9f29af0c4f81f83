// SPDX-License-Identifier: MIT
#include "homolog/base/parallel.h"

#include <atomic>
#include <utility>

#include "homolog/base/task_pool.h"

namespace homolog {
namespace {

thread_local const std::function<void()>* checkpoint = nullptr;

}  // namespace

Checkpoint::Checkpoint(std::function<void()> check) : check_(std::move(check)), outer_(checkpoint) { checkpoint = &check_; }
Checkpoint::~Checkpoint() { checkpoint = outer_; }

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  // What comes before the loop happens before each range, and each range before what comes after; no range before another. oneTBB sees to
  // that, but out of ThreadSanitizer's sight (task_pool.h): these two tell it.
  std::atomic<bool> begun{false};
  std::atomic<std::size_t> done{0};
  begun.store(true, std::memory_order_release);
  run_in_ranges(count, [&](std::size_t begin, std::size_t end) {
    (void)begun.load(std::memory_order_acquire);
    for (std::size_t i = begin; i != end; ++i) {
      if (checkpoint) (*checkpoint)();
      body(i);
    }
    done.fetch_add(1, std::memory_order_release);
  });
  (void)done.load(std::memory_order_acquire);
}

ThreadLimit::ThreadLimit(int threads) {
  if (threads > 0) control_ = limit_of_threads(static_cast<std::size_t>(threads));
}

}  // namespace homolog
