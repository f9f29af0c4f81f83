// SPDX-License-Identifier: MIT
// bench_transfer: whether the expected error of carried points orders and bounds the true one, and whether coverage tells what is there.
#include "homolog/match/transfer.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "generate.h"
#include "solids.h"

namespace {

using namespace homolog;
using namespace homolog::bench;

constexpr std::size_t points_of_a_match = 400;
constexpr std::size_t matches_of_a_pair = 4;
constexpr double right_map = 0.1;  // median error, in extents, below which a match counts as right

/// One carried point of a right match; lengths in matched extents.
struct Sample {
  double expected, error;
  bool there;
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> rank(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<double>(i);
  return rank;
}

/// Spearman's rank correlation, ties by order.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const std::vector<double> ra = ranks(a), rb = ranks(b);
  const double middle = (static_cast<double>(a.size()) - 1) / 2;
  double ab = 0, aa = 0;
  for (std::size_t i = 0; i < ra.size(); ++i) {
    ab += (ra[i] - middle) * (rb[i] - middle);
    aa += (ra[i] - middle) * (ra[i] - middle);
  }
  return aa > 0 ? ab / aa : 0;
}

/// The samples of one match against one answer; none when the map is wrong.
std::vector<Sample> judge(const MatchMap& match, const std::vector<Vec3>& model, const std::vector<Vec3>& data) {
  std::vector<Vec3> from, to;
  const std::size_t step = std::max<std::size_t>(1, model.size() / points_of_a_match);
  for (std::size_t i = 0; i < model.size(); i += step) {
    from.push_back(model[i]);
    to.push_back(data[i]);
  }
  const double extent = matched_extent(match.model_diagonal, match.scale, match.data_diagonal);
  const auto carried = carry_points(match, from, Direction::data_from_model);
  std::vector<Sample> samples;
  std::vector<double> errors;
  for (std::size_t i = 0; i < from.size(); ++i) {
    errors.push_back((carried[i].position - to[i]).norm() / extent);
    samples.push_back({carried[i].expected_error / extent, errors.back(), carried[i].is_there()});
  }
  return median(errors) < right_map ? samples : std::vector<Sample>{};
}

/// Samples of all right matches of a case, match by match.
std::vector<std::vector<Sample>> run(const Case& one) {
  const Mesh model_mesh = one.model.read(), data_mesh = one.data.read();
  const auto truths = one.truths(model_mesh, data_mesh);
  if (truths.empty() || !truths.front().dense) return {};
  const Shape model = describe_shape(model_mesh), data = describe_shape(data_mesh);
  const Family family = match_shapes(model, data);
  const auto maps = match_maps(family.matches, model, data, covered_parts({model_mesh, model}, {data_mesh, data}, family.matches));
  std::vector<std::vector<Sample>> all;
  for (std::size_t m = 0; m < std::min(matches_of_a_pair, maps.size()); ++m) {
    const TruePoints& truth = truths.front();
    std::vector<Sample> samples = judge(maps[m], truth.model, truth.data);
    if (samples.empty() && !truth.swapped_data.empty()) samples = judge(maps[m], truth.model, truth.swapped_data);
    if (!samples.empty()) all.push_back(std::move(samples));
  }
  return all;
}

struct Summary {
  std::vector<double> expected, error, correlations;
  double missing_error = 0;
  std::size_t missing = 0;

  void add(const std::vector<Sample>& samples) {
    std::vector<double> a, b;
    for (const Sample& s : samples) {
      if (s.there) {
        a.push_back(s.expected);
        b.push_back(s.error);
      } else {
        missing_error += s.error;
        ++missing;
      }
    }
    if (a.size() < 10) return;
    correlations.push_back(rank_correlation(a, b));
    expected.insert(expected.end(), a.begin(), a.end());
    error.insert(error.end(), b.begin(), b.end());
  }

  double below(double factor) const {
    double count = 0;
    for (std::size_t i = 0; i < error.size(); ++i) count += error[i] < factor * expected[i];
    return count / static_cast<double>(error.size());
  }
};

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(std::max<std::size_t>(1, values.size()));
}

void print(const Summary& all) {
  if (all.error.empty()) return fmt::print("no right match\n");
  fmt::print("right matches {}; points carried {}, mean error {:.4f}; said to be missing {}, mean error there {:.4f}\n",
             all.correlations.size(), all.error.size(), mean(all.error), all.missing,
             all.missing ? all.missing_error / static_cast<double>(all.missing) : 0.0);
  fmt::print("true error below the expected one {:.3f}, below three times it {:.3f}; rank correlation {:.3f}, within a match {:.3f}\n",
             all.below(1), all.below(3), rank_correlation(all.expected, all.error), mean(all.correlations));
  const std::vector<double> rank = ranks(all.expected);
  for (int fifth = 0; fifth < 5; ++fifth) {
    std::vector<double> a, b;
    for (std::size_t i = 0; i < rank.size(); ++i) {
      if (static_cast<int>(5 * rank[i] / static_cast<double>(rank.size())) != fifth) continue;
      a.push_back(all.expected[i]);
      b.push_back(all.error[i]);
    }
    fmt::print("  fifth {}: expected {:.4f}, true median {:.4f}, mean {:.4f}\n", fifth + 1, median(a), median(b), mean(b));
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Whether the expected error of carried points can be trusted; lengths in matched extents");
  std::string folder, filter;
  app.add_option("FOLDER", folder, "Folder with pairs.tsv, shapes and dense truth; without it, cases are made from solids in code");
  app.add_option("--filter", filter, "Only pairs with this text in the name of model or data");
  CLI11_PARSE(app, argc, argv);
  try {
    Summary all;
    for (const Case& one : folder.empty() ? generated_cases(example_meshes(), {}, 1) : cases_of(folder, read_pairs(folder))) {
      const bool named = one.pair.model.find(filter) != std::string::npos || one.pair.data.find(filter) != std::string::npos;
      if (!named || one.pair.task == "scene") continue;
      const auto matches = run(one);
      for (const auto& samples : matches) all.add(samples);
      if (!matches.empty()) fmt::print(stderr, "{} in {}: {} right\n", one.pair.model, one.pair.data, matches.size());
    }
    print(all);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_transfer: {}\n", error.what());
    return 2;
  }
  return 0;
}
