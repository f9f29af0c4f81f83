// SPDX-License-Identifier: MIT
#include "homolog/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "homolog/base/task_pool.h"

namespace homolog {
namespace {

thread_local const std::function<void()>* checkpoint = nullptr;

// What comes before a loop happens before each range, and each range before what comes after; no range before another. oneTBB sees to that,
// but out of ThreadSanitizer's sight (task_pool.h): these two tell it.
std::atomic<std::size_t> begun{0}, done{0};

void run_range(void* loop, std::size_t begin, std::size_t end) {
  (void)begun.load(std::memory_order_acquire);
  const auto& body = **static_cast<const std::function<void(std::size_t)>**>(loop);
  for (std::size_t i = begin; i != end; ++i) {
    if (checkpoint) (*checkpoint)();
    body(i);
  }
  done.fetch_add(1, std::memory_order_release);
}

}  // namespace

Checkpoint::Checkpoint(std::function<void()> check) : check_(std::move(check)), outer_(checkpoint) { checkpoint = &check_; }
Checkpoint::~Checkpoint() { checkpoint = outer_; }

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  const std::function<void(std::size_t)>* loop = &body;
  begun.fetch_add(1, std::memory_order_release);
  run_in_ranges(count, run_range, &loop);
  (void)done.load(std::memory_order_acquire);
}

ThreadLimit::ThreadLimit(int threads) : control_(limit_of_threads(static_cast<std::size_t>(std::max(0, threads)))) {}

}  // namespace homolog
