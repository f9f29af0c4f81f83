// SPDX-License-Identifier: MIT
// Options that are whole numbers.
#pragma once

#include <cstdint>
#include <string>

namespace homolog::cli {

/// What an option was given, in digits or as 2e6. Throws UsageError when it is no whole number or not in the range.
std::int64_t whole_number(const std::string& option, const std::string& text, std::int64_t least, std::int64_t most);

}  // namespace homolog::cli
