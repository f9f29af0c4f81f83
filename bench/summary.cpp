// SPDX-License-Identifier: MIT
#include "summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "instances.h"

namespace homolog::bench {
namespace {

using Group = std::vector<const Result*>;

double mean_of(const Group& group, const std::function<double(const Result&)>& value) {
  double sum = 0;
  for (const Result* r : group) sum += value(*r);
  return group.empty() ? 0 : sum / static_cast<double>(group.size());
}

Group found_of(const Group& group) {
  Group found;
  std::copy_if(group.begin(), group.end(), std::back_inserter(found), [](const Result* r) { return r->score.found; });
  return found;
}

// Nothing found is farther off than anything found.
double median_transfer(const Group& group) {
  std::vector<double> values;
  for (const Result* r : group) values.push_back(r->score.found ? r->score.transfer.median : std::numeric_limits<double>::infinity());
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[(values.size() - 1) / 2];
}

double share_right(const Result& r) {
  return r.score.first.judged > 0 ? static_cast<double>(r.score.first.right) / r.score.first.judged : 0;
}

std::string line(const std::string& name, const Group& group) {
  const auto mean = [&](auto member) { return mean_of(group, member); };
  return fmt::format(
      "{:<22} {:>5} {:>5} {:>7.3f} {:>6.3f} {:>6.3f} {:>6.3f} {:>6.1f} {:>9.4f} {:>9.4f} {:>6.3f} {:>6.3f} {:>6.3f} {:>6.2f}\n", name,
      group.size(), found_of(group).size(), mean([](const Result& r) { return r.score.success; }),
      mean([](const Result& r) { return r.score.success_in_six; }), mean([](const Result& r) { return r.score.success_direct; }),
      mean(share_right), mean([](const Result& r) { return r.score.first.right; }), median_transfer(group),
      mean_of(found_of(group), [](const Result& r) { return r.score.transfer.mean; }),
      mean([](const Result& r) { return r.score.transfer.within_05; }), mean([](const Result& r) { return r.score.transfer.within_10; }),
      calibration_error(group), mean([](const Result& r) { return r.cpu_seconds; }));
}

std::string lines_by(const Group& all, const std::function<std::string(const Result&)>& key) {
  std::vector<std::pair<std::string, Group>> groups;  // in the order of the list
  for (const Result* r : all) {
    const std::string name = key(*r);
    auto place = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == name; });
    if (place == groups.end()) place = groups.insert(groups.end(), {name, {}});
    place->second.push_back(r);
  }
  std::string text;
  for (const auto& [name, group] : groups) text += line(name, group);
  return text;
}

struct HandednessCounts {
  int right = 0, wrong = 0, ambiguous = 0;
  int all() const { return right + wrong + ambiguous; }
};

// Without a swapped truth a shape may be symmetric all the same: nobody has said where its points go.
std::string handedness_line(const Group& group) {
  std::array<HandednessCounts, 2> counts;  // by whether a swapped truth is known
  int mirrored = 0;
  for (const Result* r : group) {
    if (!r->score.success) continue;
    HandednessCounts& count = counts[r->score.has_swap];
    const bool unsure = r->score.handedness == Handedness::ambiguous;
    ++(unsure ? count.ambiguous : r->score.handedness_right ? count.right : count.wrong);
    mirrored += r->score.handedness == Handedness::mirrored;
  }
  const auto& [without, with] = counts;
  return fmt::format(
      "handedness of right first matches: {} right, {} wrong, {} ambiguous; {} told mirrored; with a swapped truth: {} of {} ambiguous; "
      "without: {} right, {} wrong, {} ambiguous\n",
      without.right + with.right, without.wrong + with.wrong, without.ambiguous + with.ambiguous, mirrored, with.ambiguous, with.all(),
      without.right, without.wrong, without.ambiguous);
}

Group without_errors(const Group& group) {
  Group whole;
  std::ranges::copy_if(group, std::back_inserter(whole), [](const Result* r) { return r->score.error.empty(); });
  return whole;
}

std::string loss_line(const Group& group, std::size_t errors) {
  std::array<int, 4> counts{};
  for (const Result* r : without_errors(group)) ++counts[static_cast<std::size_t>(r->score.lost)];
  return fmt::format("lost at: points {}, family {}, ranking {}; ok {}; errors {}\n", counts[0], counts[1], counts[2], counts[3], errors);
}

struct Bin {
  int count = 0;
  double confidence = 0, success = 0;
};

std::array<Bin, 5> calibration_bins(const Group& group) {
  std::array<Bin, 5> bins;
  for (const Result* r : found_of(group)) {
    Bin& bin = bins[static_cast<std::size_t>(std::clamp(r->score.confidence * 5, 0.0, 4.0))];
    ++bin.count;
    bin.confidence += r->score.confidence;
    bin.success += r->score.first.success;
  }
  return bins;
}

std::string calibration_line(const Group& group) {
  std::string text = "confidence of first matches, told / right (count):";
  for (const Bin& bin : calibration_bins(group)) {
    if (bin.count > 0) text += fmt::format("  {:.2f} / {:.2f} ({})", bin.confidence / bin.count, bin.success / bin.count, bin.count);
  }
  return fmt::format("{}; error {:.3f}\n", text, calibration_error(group));
}

std::string scene_lines(const Group& all) {
  Group scenes;
  std::copy_if(all.begin(), all.end(), std::back_inserter(scenes), [](const Result* r) { return r->score.instances > 1; });
  if (scenes.empty()) return "";
  const double exact = mean_of(scenes, [](const Result& r) { return r.score.instances_claimed == r.score.instances; });
  return fmt::format("scenes with several copies: {}; F1 of instances {:.3f}, count exact in {:.3f}\n", scenes.size(),
                     mean_of(scenes, [](const Result& r) { return instance_f1(r.score); }), exact);
}

// Of the found; nothing found is rare, and told in the table.
std::string landmark_line(const Group& group) {
  std::vector<double> errors;
  for (const Result* r : group) {
    if (r->pair.task == "whole") errors.insert(errors.end(), r->score.along_surface.begin(), r->score.along_surface.end());
  }
  if (errors.empty()) return "";
  std::string text = "clicked landmarks of wholes, along the surface / sqrt(area):";
  for (const double limit : {.05, .10, .15, .25}) {
    const auto within = std::ranges::count_if(errors, [&](double e) { return e <= limit; });
    text += fmt::format("  <={:.2f} {:.3f}", limit, static_cast<double>(within) / static_cast<double>(errors.size()));
  }
  return fmt::format("{} ({})\n", text, errors.size());
}

// A pair that throws claims nothing, but not because it was told apart.
std::string unrelated_line(const Group& group) {
  if (group.empty()) return "";
  const Group told = without_errors(group);
  const auto claimed = std::ranges::count_if(told, [](const Result* r) { return r->score.instances_claimed > 0; });
  return fmt::format("pairs that share nothing: {}; claimed with confidence of .5 or more: {}; errors besides: {}\n", told.size(), claimed,
                     group.size() - told.size());
}

}  // namespace

double calibration_error(const std::vector<const Result*>& results) {
  double error = 0, count = 0;
  for (const Bin& bin : calibration_bins(results)) error += std::abs(bin.confidence - bin.success), count += bin.count;
  return count > 0 ? error / count : 0;
}

std::string complaint(const std::vector<Result>& results) {
  if (results.empty()) return "there are no pairs to match: the list is empty, or none is of this name and task";
  const auto errors = std::ranges::count_if(results, [](const Result& r) { return !r.score.error.empty(); });
  return errors > 0 ? fmt::format("{} of {} pairs ended in an error", errors, results.size()) : "";
}

std::string summary(const std::vector<Result>& results) {
  Group all, sharing_nothing, judged;
  for (const Result& r : results) {
    if (!r.judged) continue;
    judged.push_back(&r);
    (r.pair.task == unrelated ? sharing_nothing : all).push_back(&r);
  }
  std::string text =
      fmt::format("{:<22} {:>5} {:>5} {:>7} {:>6} {:>6} {:>6} {:>6} {:>9} {:>9} {:>6} {:>6} {:>6} {:>6}\n", "", "pairs", "found", "success",
                  "in six", "direct", "share", "right", "transfer", "mean", "<=.05", "<=.10", "calib", "CPU s");
  text += lines_by(all, [](const Result& r) { return r.pair.task; });
  text += lines_by(all, [](const Result& r) { return set_of(r.pair); });
  text += line("all", all) + loss_line(all, judged.size() - without_errors(judged).size()) + handedness_line(all) +
          calibration_line(judged) + landmark_line(all) + scene_lines(all) + unrelated_line(sharing_nothing);
  const std::size_t unjudged = results.size() - judged.size();
  return unjudged > 0 ? text + fmt::format("without truth: {}\n", unjudged) : text;
}

}  // namespace homolog::bench
