// SPDX-License-Identifier: MIT
#include "run_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#include "homolog/shape/read_mesh.h"
#include "instances.h"
#include "read_truth.h"
#include "shapes.h"

namespace homolog::bench {
namespace {

std::string counts_text(const StageCounts& counts) {
  std::string text;
  for (const auto& [name, count] : counts.stages) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, count);
  return text;
}

// The first match's pairs, in an order that does not depend on how they were found.
std::string told_text(const Family& family) {
  if (family.matches.empty()) return "";
  std::vector<std::pair<int, int>> pairs;
  for (const Correspondence& c : family.matches.front().pairs) pairs.emplace_back(c.model, c.data);
  std::sort(pairs.begin(), pairs.end());
  std::string text;
  for (const auto& [model, data] : pairs) text += fmt::format("{}{}:{}", text.empty() ? "" : " ", model, data);
  return text;
}

PairScore score(const Case& one, const Family& family, const DescribedShape& model, const DescribedShape& data) {
  if (one.pair.task == unrelated) return score_unrelated(family, model.shape.points, data.shape.points);
  std::vector<Truth> truths;
  for (const TruePoints& points : one.truths(model.mesh, data.mesh)) truths.push_back(make_truth(points, model.turn, data.turn));
  if (truths.empty()) return score_unrelated(family, model.shape.points, data.shape.points);
  PairScore result = score_instances(family, model.shape.points, data.shape.points, truths, data.diagonal);
  if (truths.size() == 1 && !truths[0].direct.dense && result.found) {
    const TrueMap& met = truths[0].answer(result.first.swapped);
    result.along_surface = errors_along_surface(family.matches.front().data_from_model, met, moved(data.turn, data.mesh));
  }
  return result;
}

Result run_case(const Case& one, const RunOptions& options, Shapes& shapes) {
  Result result;
  result.pair = one.pair;
  const auto model = shapes.get(one.model.name, options.model_seed, one.model.read);
  const auto data = shapes.get(one.data.name, options.seed, one.data.read);
  const double start = thread_seconds();
  const Family family = match_shapes(model->shape, data->shape, options.params);
  result.cpu_seconds = model->cpu_seconds + data->cpu_seconds + thread_seconds() - start;
  result.counts = counts_text(family.counts);
  result.told = told_text(family);
  result.score = score(one, family, *model, *data);
  result.judged = one.pair.task == unrelated || result.score.instances > 0;
  return result;
}

// Hands results on in the order of the list, whichever is done first.
class InOrder {
 public:
  InOrder(std::vector<Result>& results, const std::function<void(const Result&)>& report)
      : results_(results), done_(results.size()), report_(report) {}

  void put(std::size_t place, Result result) {
    const std::lock_guard lock(mutex_);
    results_[place] = std::move(result);
    done_[place] = true;
    for (; next_ < done_.size() && done_[next_]; ++next_) report_(results_[next_]);
  }

 private:
  std::mutex mutex_;
  std::vector<Result>& results_;
  std::vector<bool> done_;
  std::size_t next_ = 0;
  const std::function<void(const Result&)>& report_;
};

}  // namespace

std::vector<Case> cases_of(const std::filesystem::path& folder, const std::vector<PairEntry>& pairs) {
  const auto truths = std::make_shared<TruthReader>(folder);
  const auto source = [&](const std::string& name) { return ShapeSource{name, [=] { return read_mesh(folder / (name + ".off")); }}; };
  std::vector<Case> cases;
  for (const PairEntry& pair : pairs) {
    const auto read = [=](const Mesh& model, const Mesh& data) {
      const auto points = truths->read(pair, model, data);
      return points ? std::vector{*points} : std::vector<TruePoints>{};
    };
    cases.push_back({pair, source(pair.model), source(pair.data), read});
  }
  return cases;
}

std::vector<Result> run_cases(const std::vector<Case>& cases, RunOptions options, const std::function<void(const Result&)>& report) {
  options.params.threads = 1;
  Shapes shapes(options.params);
  for (const Case& one : cases) shapes.expect(one.model.name, options.model_seed), shapes.expect(one.data.name, options.seed);
  std::vector<Result> results(cases.size());
  InOrder in_order(results, report);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < cases.size(); i = next++) {
      Result result;
      try {
        result = run_case(cases[i], options, shapes);
      } catch (const std::exception& error) {
        result.pair = cases[i].pair;
        result.score.error = error.what();
      }
      in_order.put(i, std::move(result));
    }
  };
  std::vector<std::jthread> workers;
  for (int t = 0; t < options.threads; ++t) workers.emplace_back(work);
  workers.clear();  // joins
  return results;
}

}  // namespace homolog::bench
