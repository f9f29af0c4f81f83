// SPDX-License-Identifier: MIT
#include "homolog/base/stopwatch.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <ctime>
#include <memory>
#include <thread>

namespace homolog {
namespace {

using testing::HasSubstr;

TEST(Stopwatch, LapsFollowEachOtherWithoutGapOrOverlap) {
  const auto start = std::chrono::steady_clock::now();
  Stopwatch watch;
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  watch.lap("sleep", 1, "naps");
  lap(&watch, "nothing", 0, "naps");
  const double all = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  ASSERT_EQ(watch.stages().size(), 2u);
  EXPECT_GE(watch.stages()[0].milliseconds, 20);
  EXPECT_LT(watch.stages()[0].cpu_milliseconds, 15);  // sleeping costs no work
  EXPECT_LE(watch.stages()[0].milliseconds + watch.stages()[1].milliseconds, all);
}

TEST(Stopwatch, TheWorkOfAChildCounts) {
  Stopwatch watch;
  const pid_t child = fork();
  if (child == 0) {
    while (std::clock() < CLOCKS_PER_SEC / 20) {  // its clock begins with it
    }
    _exit(0);
  }
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  watch.lap("child", 1, "children");
  watch.lap("nothing", 0, "children");
  EXPECT_GE(watch.stages()[0].cpu_milliseconds, 45);
  EXPECT_LT(watch.stages()[1].cpu_milliseconds, 15);  // and counts once
}

TEST(Stopwatch, NobodyNeedsToWatch) { lap(nullptr, "unseen", 1, "things"); }

TEST(Stopwatch, MemoryThatWasHeldIsTold) {
  const std::size_t before = peak_memory(), bytes = before + (64 << 20);
  const auto block = std::make_unique<char[]>(bytes);
  std::memset(block.get(), 1, bytes);
  ASSERT_EQ(block[bytes / 2], 1);
  EXPECT_GE(peak_memory(), bytes);
}

TEST(Stopwatch, TableTellsEveryStageAndTheirSum) {
  const std::string table = timing_table({{"voxels", 1.5, 2.5, 1 << 20, 7, "voxels"}, {"body", 2, 3, 3 << 20, 9, "nodes"}});
  EXPECT_THAT(table, HasSubstr("voxels                              1.5        2.5        1.0  7 voxels\n"));
  EXPECT_THAT(table, HasSubstr("all                                 3.5        5.5        3.0\n"));
}

}  // namespace
}  // namespace homolog
