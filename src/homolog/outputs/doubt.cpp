// SPDX-License-Identifier: MIT
#include "homolog/outputs/doubt.h"

#include <fmt/format.h>

#include <algorithm>

namespace homolog {
namespace {

constexpr double likely = 0.5;

}  // namespace

std::string doubt_sentence(const Family& family) {
  const auto best = std::max_element(family.matches.begin(), family.matches.end(),
                                     [](const Match& a, const Match& b) { return a.confidence < b.confidence; });
  if (best == family.matches.end() || best->confidence >= likely) return "";
  return fmt::format("No match here is likely to be right: the highest confidence is {:.2f}.", best->confidence);
}

std::string doubt_of_match(double confidence) {
  return confidence < likely ? fmt::format("this match is more likely wrong than right: its confidence is {:.2f}", confidence) : "";
}

}  // namespace homolog
