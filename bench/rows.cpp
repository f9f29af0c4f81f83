// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <functional>

#include "summary.h"

namespace homolog::bench {
namespace {

std::string outcome(const Result& result) {
  if (!result.score.error.empty()) return "error";
  if (!result.judged) return "no truth";
  if (!result.score.found) return "nothing";
  return result.score.success ? "right" : "wrong";
}

double share(const MatchScore& score) { return score.judged > 0 ? static_cast<double>(score.right) / score.judged : 0; }

struct Cell {
  const char* column;
  std::string value;
};

std::vector<Cell> cells(const Result& result) {
  const PairScore& s = result.score;
  const auto number = [](const auto& value) { return fmt::format("{}", value); };
  const auto rounded = [](double value) { return fmt::format("{:.4f}", value); };
  return {{"task", result.pair.task},
          {"model", result.pair.model},
          {"data", result.pair.data},
          {"outcome", outcome(result)},
          {"rank_of_right", number(s.first_right)},
          {"in_six", number(int{s.success_in_six})},
          {"direct", number(int{s.success_direct})},
          {"pairs", number(s.first.pairs)},
          {"judged", number(s.first.judged)},
          {"right", number(s.first.right)},
          {"swapped", number(int{s.first.swapped})},
          {"share_right", rounded(share(s.first))},
          {"transfer_median", rounded(s.transfer.median)},
          {"transfer_mean", rounded(s.transfer.mean)},
          {"within_05", rounded(s.transfer.within_05)},
          {"within_10", rounded(s.transfer.within_10)},
          {"confidence", rounded(s.confidence)},
          {"handedness", s.found ? handedness_name(s.handedness) : ""},
          {"model_points", number(s.model_points)},
          {"data_points", number(s.data_points)},
          {"findable", number(s.findable)},
          {"findable_found", number(s.findable_found)},
          {"matches", number(s.matches)},
          {"instances", number(s.instances)},
          {"instances_claimed", number(s.instances_claimed)},
          {"instances_right", number(s.instances_right)},
          {"lost", result.judged ? stage_name(s.lost) : ""},
          {"cpu_seconds", rounded(result.cpu_seconds)},
          {"counts", result.counts},
          {"told", result.told},
          {"error", s.error}};
}

std::string joined(const Result& result, const std::function<std::string(const Cell&)>& text) {
  std::vector<std::string> texts;
  for (const Cell& cell : cells(result)) texts.push_back(text(cell));
  return fmt::format("{}", fmt::join(texts, "\t"));
}

}  // namespace

std::string row_header() {
  return joined({}, [](const Cell& cell) { return std::string(cell.column); });
}

std::string row(const Result& result) {
  return joined(result, [](const Cell& cell) { return cell.value; });
}

std::string readable_header() {
  return fmt::format("{:<9} {:<39} {:<34} {:<8} {:>4} {:>9} {:>6} {:>6} {:>5} {:>5} {:>5} {:>9} {:>4} {:>9} {:>9} {:>7}  {}", "task",
                     "model", "data", "outcome", "rank", "right/prs", "median", "mean", "<=.05", "<=.10", "conf", "hand", "inst", "points",
                     "findable", "lost", "CPU s");
}

std::string readable_row(const Result& result) {
  const PairScore& s = result.score;
  if (!s.error.empty()) return fmt::format("{:<9} {:<39} {:<34} error: {}", result.pair.task, result.pair.model, result.pair.data, s.error);
  return fmt::format(
      "{:<9} {:<39} {:<34} {:<8} {:>4} {:>9} {:>6.3f} {:>6.3f} {:>5.2f} {:>5.2f} {:>5.2f} {:>9} {:>4} {:>9} {:>9} {:>7}  {:.2f}",
      result.pair.task, result.pair.model, result.pair.data, outcome(result), s.first_right,
      fmt::format("{}/{}{}", s.first.right, s.first.judged, s.first.swapped ? "s" : ""), s.transfer.median, s.transfer.mean,
      s.transfer.within_05, s.transfer.within_10, s.confidence, s.found ? handedness_name(s.handedness) : "-",
      fmt::format("{}/{}", s.instances_right, s.instances), fmt::format("{}x{}", s.model_points, s.data_points),
      fmt::format("{}/{}", s.findable_found, s.findable), result.judged ? stage_name(s.lost) : "-", result.cpu_seconds);
}

}  // namespace homolog::bench
