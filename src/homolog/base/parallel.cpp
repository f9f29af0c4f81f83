// SPDX-License-Identifier: MIT
#include "homolog/base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <utility>

namespace homolog {
namespace {

thread_local const std::function<void()>* checkpoint = nullptr;

}  // namespace

Checkpoint::Checkpoint(std::function<void()> check) : check_(std::move(check)), outer_(checkpoint) { checkpoint = &check_; }
Checkpoint::~Checkpoint() { checkpoint = outer_; }

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      if (checkpoint) (*checkpoint)();
      body(i);
    }
  });
}

struct ThreadLimit::State {
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads) {
  if (threads > 0) {
    state_.reset(new State{tbb::global_control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads))});
  }
}
ThreadLimit::~ThreadLimit() = default;

}  // namespace homolog
