// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "summary.h"

namespace homolog::bench {
namespace {

constexpr const char* columns[] = {
    "task",        "model",      "data",         "outcome",     "rank_of_right",   "in_six",         "direct",    "pairs",
    "judged",      "right",      "swapped",      "share_right", "transfer_median", "transfer_mean",  "within_05", "within_10",
    "confidence",  "handedness", "model_points", "data_points", "findable",        "findable_found", "matches",   "lost",
    "cpu_seconds", "counts",     "error"};

std::string outcome(const Result& result) {
  if (!result.score.error.empty()) return "error";
  if (!result.judged) return "no truth";
  if (!result.score.found) return "nothing";
  return result.score.success ? "right" : "wrong";
}

double share(const MatchScore& score) { return score.judged > 0 ? static_cast<double>(score.right) / score.judged : 0; }

}  // namespace

std::string row_header() { return fmt::format("{}", fmt::join(columns, "\t")); }

std::string row(const Result& result) {
  const PairScore& s = result.score;
  return fmt::format(
      "{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{:.3f}\t{:.4f}\t{:.4f}\t{:.3f}\t{:.3f}\t{:.3f}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{:.2f}\t{}"
      "\t{}",
      result.pair.task, result.pair.model, result.pair.data, outcome(result), s.first_right, int{s.success_in_six}, int{s.success_direct},
      s.first.pairs, s.first.judged, s.first.right, int{s.first.swapped}, share(s.first), s.transfer.median, s.transfer.mean,
      s.transfer.within_05, s.transfer.within_10, s.confidence, handedness_name(s.handedness), s.model_points, s.data_points, s.findable,
      s.findable_found, s.matches, result.judged ? stage_name(s.lost) : "-", result.cpu_seconds, result.counts, s.error);
}

std::string readable_header() {
  return fmt::format("{:<6} {:<39} {:<34} {:<8} {:>4} {:>9} {:>6} {:>6} {:>5} {:>9} {:>9} {:>7}  {}", "task", "model", "data", "outcome",
                     "rank", "right/prs", "median", "mean", "conf", "points", "findable", "lost", "CPU s");
}

std::string readable_row(const Result& result) {
  const PairScore& s = result.score;
  if (!s.error.empty()) return fmt::format("{:<6} {:<39} {:<34} error: {}", result.pair.task, result.pair.model, result.pair.data, s.error);
  return fmt::format("{:<6} {:<39} {:<34} {:<8} {:>4} {:>9} {:>6.3f} {:>6.3f} {:>5.2f} {:>9} {:>9} {:>7}  {:.2f}", result.pair.task,
                     result.pair.model, result.pair.data, outcome(result), s.first_right,
                     fmt::format("{}/{}{}", s.first.right, s.first.judged, s.first.swapped ? "s" : ""), s.transfer.median, s.transfer.mean,
                     s.confidence, fmt::format("{}x{}", s.model_points, s.data_points), fmt::format("{}/{}", s.findable_found, s.findable),
                     result.judged ? stage_name(s.lost) : "-", result.cpu_seconds);
}

}  // namespace homolog::bench
