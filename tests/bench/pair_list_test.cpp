// SPDX-License-Identifier: MIT
// The list of pairs as people write it, and what is refused.
#include "pair_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "folder.h"
#include "outputs/message_of.h"

namespace homolog::bench {
namespace {

using testing::HasSubstr;

TEST(PairList, ReadsLinesOfEitherSystem) {
  const Folder folder;
  folder.write("pairs.tsv", "task\tmodel\tdata\tground_truth\r\nwhole\ts/a\ts/b\r\n\r\npart\ts/c\ts/d\ttold\tmore\r\n");
  const auto pairs = read_pairs(folder.path);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].data, "s/b");
  EXPECT_EQ(pairs[1].task, "part");
  EXPECT_EQ(pairs[1].truth, "told");
  EXPECT_EQ(set_of(pairs[1]), "s");
}

TEST(PairList, RefusesWhatIsNone) {
  const Folder folder;
  const auto fault = [&] { return message_of([&] { read_pairs(folder.path); }); };
  EXPECT_THAT(fault(), HasSubstr("pairs.tsv: cannot be read"));
  folder.write("pairs.tsv", "");
  EXPECT_THAT(fault(), HasSubstr("pairs.tsv, line 1: expected the columns' names"));
  folder.write("pairs.tsv", "whole\ts/a\ts/b\ttold\n");
  EXPECT_THAT(fault(), HasSubstr("pairs.tsv, line 1: expected the columns' names"));
  folder.write("pairs.tsv", "task\tmodel\tdata\tground_truth\n\nwhole\ts/a\n");
  EXPECT_THAT(fault(), HasSubstr("pairs.tsv, line 3: expected at least"));
}

}  // namespace
}  // namespace homolog::bench
