// SPDX-License-Identifier: MIT
#include "homolog/base/task_pool.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <exception>
#include <typeinfo>

#include "homolog/base/errors.h"

namespace homolog {
namespace {

std::atomic<tbb::global_control*> unlifted = nullptr;

/// Lifts a limit, which starts threads for the work that is left. That throws where memory has ended, so while another exception passes
/// the limit stays until the next one is set.
void lift(tbb::global_control* limit) { delete (std::uncaught_exceptions() == 0 ? limit : unlifted.exchange(limit)); }

}  // namespace

void run_in_ranges(std::size_t count, void (*work)(void* loop, std::size_t begin, std::size_t end), void* loop) {
  try {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                      [=](const tbb::blocked_range<std::size_t>& range) { work(loop, range.begin(), range.end()); });
  } catch (const std::runtime_error& error) {
    if (typeid(error) != typeid(std::runtime_error)) throw;  // of the work; oneTBB's own has no type
    throw Error(
        fmt::format("no thread could be started ({}): there is not enough memory, or there are too many; try --threads 1", error.what()));
  }
}

std::shared_ptr<void> limit_of_threads(std::size_t threads) {
  delete unlifted.exchange(nullptr);
  if (threads == 0) return nullptr;
  return {new tbb::global_control(tbb::global_control::max_allowed_parallelism, threads), lift};
}

}  // namespace homolog
