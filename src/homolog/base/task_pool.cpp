// SPDX-License-Identifier: MIT
#include "homolog/base/task_pool.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

namespace homolog {

void run_in_ranges(std::size_t count, void (*work)(void* loop, std::size_t begin, std::size_t end), void* loop) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                    [=](const tbb::blocked_range<std::size_t>& range) { work(loop, range.begin(), range.end()); });
}

std::shared_ptr<void> limit_of_threads(std::size_t threads) {
  return std::make_shared<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
}

}  // namespace homolog
