// SPDX-License-Identifier: MIT
// Runs of the bench: what turning the shapes may change, and how pairs are judged that share nothing or throw.
#include "run_cases.h"

#include <gtest/gtest.h>

#include "fixtures/solids.h"
#include "generate.h"

namespace homolog::bench {
namespace {

Result run_one(const Case& one, RunOptions options) {
  options.threads = 1;
  return run_cases({one}, options, [](const Result&) {}).front();
}

TEST(RunCases, TurningTheModelTurnsItsTruthAndKeepsThePairs) {
  const Mesh mesh = mesh_of(fixtures::quadruped(), 40);
  const Case same = generated_cases({{"quadruped", mesh}}, {}, 1).front();
  const Result first = run_one(same, {.seed = 1}), turned = run_one(same, {.seed = 1, .model_seed = 7});
  EXPECT_TRUE(first.score.success);
  EXPECT_TRUE(turned.score.success);
  EXPECT_LT(turned.score.transfer.median, 0.01);
  EXPECT_NE(first.told, "");
  EXPECT_EQ(first.told, turned.told);
}

TEST(RunCases, UnrelatedPairsAreJudgedByTheirTask) {
  const Mesh mesh = mesh_of(fixtures::box({0, 0, 0}, {0.2, 0.5, 1}), 20);
  Case one = generated_cases({{"box", mesh}}, {}, 1).front();
  one.pair.task = unrelated;  // though its truth is known
  const Result result = run_one(one, {});
  EXPECT_TRUE(result.judged);
  EXPECT_EQ(result.score.error, "");
  EXPECT_EQ(result.score.instances, 0);
  EXPECT_EQ(result.score.success, result.score.instances_claimed == 0);
}

}  // namespace
}  // namespace homolog::bench
