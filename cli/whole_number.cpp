// SPDX-License-Identifier: MIT
#include "whole_number.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "exit_codes.h"

namespace homolog::cli {

std::int64_t whole_number(const std::string& option, const std::string& text, std::int64_t least, std::int64_t most) {
  double value = NAN;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = error == std::errc() && end == text.data() + text.size() && value == std::floor(value);
  if (is_number && value >= static_cast<double>(least) && value <= static_cast<double>(most)) return static_cast<std::int64_t>(value);
  throw UsageError(fmt::format("{} is '{}', but must be a whole number from {} to {}", option, text, least, most));
}

}  // namespace homolog::cli
