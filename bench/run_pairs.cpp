// SPDX-License-Identifier: MIT
#include "run_pairs.h"

#include <fmt/format.h>

#include <atomic>
#include <mutex>
#include <thread>

#include "homolog/shape/read_mesh.h"
#include "read_truth.h"
#include "shapes.h"

namespace homolog::bench {
namespace {

std::string counts_text(const StageCounts& counts) {
  std::string text;
  for (const auto& [name, count] : counts.stages) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, count);
  return text;
}

// The truth goes where the data shape was turned to.
Truth turned_truth(TruePoints points, const Similarity& turn) {
  for (Vec3& p : points.data) p = turn(p);
  for (Vec3& p : points.swapped_data) p = turn(p);
  return make_truth(points);
}

Result run_pair(const std::filesystem::path& folder, const PairEntry& pair, const Params& params, Shapes& shapes, TruthReader& truths) {
  Result result;
  result.pair = pair;
  const auto model = shapes.get(pair.model, false, [&] { return read_mesh(folder / (pair.model + ".off")); });
  const auto data = shapes.get(pair.data, true, [&] { return read_mesh(folder / (pair.data + ".off")); });
  const double start = thread_seconds();
  const Family family = match_shapes(model->shape, data->shape, params);
  result.cpu_seconds = model->cpu_seconds + data->cpu_seconds + thread_seconds() - start;
  result.counts = counts_text(family.counts);
  const auto points = truths.read(pair, model->mesh, data->mesh);
  result.judged = points.has_value();
  if (!points) return result;
  result.score = score_family(family, model->shape.points, data->shape.points, turned_truth(*points, data->turn), data->diagonal);
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

std::vector<Result> run_pairs(const std::filesystem::path& folder, const std::vector<PairEntry>& pairs, const RunOptions& options,
                              const std::function<void(const Result&)>& report) {
  Params params = options.params;
  params.threads = 1;
  Shapes shapes(params, options.seed);
  for (const PairEntry& pair : pairs) shapes.expect(pair.model, false), shapes.expect(pair.data, true);
  TruthReader truths(folder);
  std::vector<Result> results(pairs.size());
  InOrder in_order(results, report);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < pairs.size(); i = next++) {
      Result result;
      try {
        result = run_pair(folder, pairs[i], params, shapes, truths);
      } catch (const std::exception& error) {
        result.pair = pairs[i];
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
