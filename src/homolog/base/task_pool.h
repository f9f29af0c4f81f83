// SPDX-License-Identifier: MIT
// oneTBB, whose code is compiled into task_pool.cpp alone: ThreadSanitizer must not look at it, for it sees only the half of it that stands
// in headers.
#pragma once

#include <cstddef>
#include <memory>

namespace homolog {

/// Calls work(loop, begin, end) for ranges that make up [0, count), on any threads. Exceptions reach the caller. A plain function, so that
/// nothing is read of the caller's before it begins. Throws Error when no thread can be started.
void run_in_ranges(std::size_t count, void (*work)(void* loop, std::size_t begin, std::size_t end), void* loop);

/// While it lives, at most `threads` threads work; 0 for all cores.
std::shared_ptr<void> limit_of_threads(std::size_t threads);

}  // namespace homolog
