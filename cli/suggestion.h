// SPDX-License-Identifier: MIT
// "Did you mean": the known word nearest to a mistyped one.
#pragma once

#include <string>
#include <vector>

namespace homolog::cli {

/// "; did you mean 'word'?" for the nearest of the words if it is close, else nothing.
std::string suggestion(const std::string& typed, const std::vector<std::string>& words);

}  // namespace homolog::cli
