// SPDX-License-Identifier: MIT
// How right dense maps are: for right first matches with dense truth, the errors of the warp and of the dense map at the same vertices,
// what is folded and torn, whether the confidence can be trusted, and the time.
#include "homolog/match/dense.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "homolog/base/parallel.h"
#include "run_cases.h"
#include "shapes.h"

namespace {

using namespace homolog;
using namespace homolog::bench;

constexpr double right_map = 0.1;    // median error, in extents, below which a match counts as right
constexpr double good_error = 0.05;  // what the confidence speaks of

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(std::max<std::size_t>(1, values.size()));
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

double share_below(const std::vector<double>& values, double limit) {
  const auto count = std::count_if(values.begin(), values.end(), [=](double value) { return value < limit; });
  return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(1, values.size()));
}

/// One right match; errors of the true vertices that have a place, in matched extents.
struct Score {
  std::vector<double> warp, dense, confidence;
  double there = 0, folded = 0, torn = 0, cpu_seconds = 0, vertices = 0;
};

/// The numbers of the vertices at these places, which are vertices.
std::vector<std::size_t> numbers_of(const std::vector<Vec3>& places, const Mesh& mesh) {
  std::map<std::array<double, 3>, std::size_t> numbers;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3& x = mesh.vertices[i];
    numbers.try_emplace({x.x(), x.y(), x.z()}, i);
  }
  std::vector<std::size_t> result;
  for (const Vec3& x : places) result.push_back(numbers.at({x.x(), x.y(), x.z()}));
  return result;
}

std::vector<double> warp_errors(const MatchMap& match, const std::vector<Vec3>& model, const std::vector<Vec3>& data, double extent) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < model.size(); ++i) errors.push_back((match.data_from_model(model[i]) - data[i]).norm() / extent);
  return errors;
}

/// None when the match is wrong under both truths.
std::optional<Score> judge(const MatchMap& match, const Mesh& model, const Mesh& data, const TruePoints& truth) {
  const double extent = matched_extent(match.model_diagonal, match.scale, match.data_diagonal);
  const std::vector<Vec3>* there = &truth.data;
  std::vector<double> errors = warp_errors(match, truth.model, *there, extent);
  if (median(errors) >= right_map && !truth.swapped_data.empty()) {
    there = &truth.swapped_data;
    errors = warp_errors(match, truth.model, *there, extent);
  }
  if (median(errors) >= right_map) return {};
  const double start = thread_seconds();
  const DenseMap map = dense_maps(match, model, data).data_from_model;
  Score score;
  score.cpu_seconds = thread_seconds() - start;
  score.vertices = static_cast<double>(model.vertices.size() + data.vertices.size());
  const std::vector<std::size_t> numbers = numbers_of(truth.model, model);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const DensePlace& place = map.places[numbers[i]];
    if (!place.is_there()) continue;
    score.warp.push_back(errors[i]);
    score.dense.push_back((place.position - (*there)[i]).norm() / extent);
    score.confidence.push_back(place.confidence);
  }
  score.there = static_cast<double>(score.dense.size()) / static_cast<double>(numbers.size());
  score.folded = static_cast<double>(map.folded) / static_cast<double>(std::max<std::size_t>(1, map.triangles));
  score.torn = static_cast<double>(map.torn) / static_cast<double>(model.vertices.size());
  return score;
}

std::optional<Score> run(const Case& one) {
  const Mesh model_mesh = one.model.read(), data_mesh = one.data.read();
  const auto truths = one.truths(model_mesh, data_mesh);
  if (truths.empty() || !truths.front().dense) return {};
  const Shape model = describe_shape(model_mesh), data = describe_shape(data_mesh);
  const Family family = match_shapes(model, data);
  if (family.matches.empty()) return {};
  const auto maps = match_maps(family.matches, model, data, covered_parts({model_mesh, model}, {data_mesh, data}, family.matches));
  const ThreadLimit one_thread(1);  // so that its CPU time is its own
  return judge(maps.front(), model_mesh, data_mesh, truths.front());
}

void print_row(const std::string& name, const std::vector<Score>& scores) {
  const auto over = [&](auto value) {
    std::vector<double> values;
    for (const Score& score : scores) values.push_back(value(score));
    return mean(values);
  };
  fmt::print("{:<18} {:>5}   {:.4f} {:.4f} {:.3f}   {:.4f} {:.4f} {:.3f}   {:.3f}  {:.4f}  {:.4f}  {:5.2f}  {:5.1f}\n", name, scores.size(),
             over([](const Score& s) { return median(s.warp); }), over([](const Score& s) { return mean(s.warp); }),
             over([](const Score& s) { return share_below(s.warp, good_error); }), over([](const Score& s) { return median(s.dense); }),
             over([](const Score& s) { return mean(s.dense); }), over([](const Score& s) { return share_below(s.dense, good_error); }),
             over([](const Score& s) { return s.there; }), over([](const Score& s) { return s.folded; }),
             over([](const Score& s) { return s.torn; }), over([](const Score& s) { return s.cpu_seconds; }),
             1e6 * over([](const Score& s) { return s.cpu_seconds / s.vertices; }));
}

/// What the confidence says and what is true, by fifths of its range.
void print_confidence(const std::vector<Score>& scores) {
  fmt::print("confidence, told / within {}:", good_error);
  for (int fifth = 0; fifth < 5; ++fifth) {
    std::vector<double> told, right;
    for (const Score& score : scores) {
      for (std::size_t i = 0; i < score.dense.size(); ++i) {
        if (std::min(4, static_cast<int>(5 * score.confidence[i])) != fifth) continue;
        told.push_back(score.confidence[i]);
        right.push_back(score.dense[i] < good_error);
      }
    }
    fmt::print("  {:.2f} / {:.2f} ({})", mean(told), mean(right), told.size());
  }
  fmt::print("\n");
}

void print(const std::map<std::string, std::vector<Score>>& sets) {
  fmt::print("{:<18} {:>5}   {:<20}   {:<20}   there  folded    torn  CPU s  us/vertex\n", "", "right", "warp: median mean .05", "dense");
  std::vector<Score> all;
  for (const auto& [name, scores] : sets) {
    print_row(name, scores);
    all.insert(all.end(), scores.begin(), scores.end());
  }
  print_row("all", all);
  print_confidence(all);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("How right dense maps are, beside the warps they begin with; lengths in matched extents, means over right first matches");
  std::string folder, filter;
  app.add_option("FOLDER", folder, "Folder with pairs.tsv, shapes and dense truth")->required();
  app.add_option("--filter", filter, "Only pairs with this text in the name of model or data");
  CLI11_PARSE(app, argc, argv);
  try {
    std::map<std::string, std::vector<Score>> sets;
    for (const Case& one : cases_of(folder, read_pairs(folder))) {
      if (one.pair.model.find(filter) == std::string::npos && one.pair.data.find(filter) == std::string::npos) continue;
      if (const auto score = run(one)) sets[set_of(one.pair)].push_back(*score);
    }
    print(sets);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_dense: {}\n", error.what());
    return 2;
  }
  return 0;
}
