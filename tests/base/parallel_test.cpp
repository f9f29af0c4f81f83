// SPDX-License-Identifier: MIT
#include "homolog/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace homolog {
namespace {

TEST(Parallel, EveryIndexIsVisitedOnce) {
  for (const std::size_t count : {0, 1, 7, 10000}) {
    std::vector<std::atomic<int>> visits(count);
    parallel_for(count, [&](std::size_t i) { ++visits[i]; });
    for (const auto& n : visits) ASSERT_EQ(n, 1);
  }
}

TEST(Parallel, ExceptionsReachTheCaller) {
  const auto fail_at_77 = [](std::size_t i) {
    if (i == 77) throw std::runtime_error("77");
  };
  EXPECT_THROW(parallel_for(1000, fail_at_77), std::runtime_error);
}

TEST(Parallel, LoopsMayContainLoops) {
  std::vector<int> sums(40);
  parallel_for(sums.size(), [&](std::size_t i) {
    std::vector<int> slots(100);
    parallel_for(slots.size(), [&](std::size_t j) { slots[j] = static_cast<int>(i); });
    for (const int s : slots) sums[i] += s;
  });
  for (int i = 0; i < 40; ++i) EXPECT_EQ(sums[i], 100 * i);
}

// Run by scripts/test.sh under ThreadSanitizer, which must report it.
TEST(Parallel, DISABLED_PlantedRace) {
  long sum = 0;
  parallel_for(1'000'000, [&](std::size_t i) { sum += static_cast<long>(i); });
  std::printf("%ld\n", sum);
}

TEST(Parallel, OneThreadIsTheCallersOwn) {
  const ThreadLimit limit(1);
  std::mutex door;
  std::set<std::thread::id> seen;
  parallel_for(2000, [&](std::size_t) {
    const std::lock_guard lock(door);
    seen.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(seen, std::set{std::this_thread::get_id()});
}

TEST(Parallel, ACheckpointStopsTheWorkOfItsThreadWhileItLives) {
  const auto loop = [] { parallel_for(1000, [](std::size_t) {}); };
  {
    const Checkpoint stop([] { throw std::runtime_error("enough"); });
    EXPECT_THROW(loop(), std::runtime_error);
    std::thread(loop).join();
  }
  loop();
}

}  // namespace
}  // namespace homolog
