// SPDX-License-Identifier: MIT
#include "part.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "exit_codes.h"

namespace homolog::cli {
namespace {

std::optional<double> share(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && value >= 0 && value <= 1 ? std::optional(value) : std::nullopt;
}

/// Cuts the box by one clause such as y>0.5; false if it is not understood.
bool cut(Box& box, std::string_view clause) {
  if (clause.size() < 3 || clause[0] < 'x' || clause[0] > 'z') return false;
  const int axis = clause[0] - 'x';
  const std::string_view rest = clause.substr(2);
  const std::size_t dots = rest.find("..");
  const bool between = clause[1] == '=' && dots != rest.npos;
  if (!between && clause[1] != '<' && clause[1] != '>') return false;
  const auto low = between ? share(rest.substr(0, dots)) : clause[1] == '>' ? share(rest) : 0.0;
  const auto high = between ? share(rest.substr(dots + 2)) : clause[1] == '<' ? share(rest) : 1.0;
  if (!low || !high) return false;
  box.min[axis] = std::max(box.min[axis], *low);
  box.max[axis] = std::min(box.max[axis], *high);
  return true;
}

}  // namespace

Box parse_part(const std::string& text) {
  Box box{Vec3::Zero(), Vec3::Ones()};
  std::string_view rest = text;
  while (true) {
    const std::size_t comma = rest.find(',');
    if (!cut(box, rest.substr(0, comma))) {
      throw UsageError(
          fmt::format("the part '{}' is not understood; write it like y>0.5 or x<0.3,z>0.2 or y=0.4..0.8, shares from 0 to 1", text));
    }
    if (comma == rest.npos) break;
    rest.remove_prefix(comma + 1);
  }
  if ((box.max - box.min).minCoeff() <= 0) throw UsageError(fmt::format("the part '{}' leaves nothing of the shape", text));
  return box;
}

}  // namespace homolog::cli
