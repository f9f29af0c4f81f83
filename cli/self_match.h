// SPDX-License-Identifier: MIT
// A shape against itself: what `homolog symmetry` and `homolog match --self` do.
#pragma once

#include <string>

#include "options.h"

namespace homolog::cli {

/// Returns the exit code.
int match_with_itself(const std::string& path, const std::optional<Box>& part, const Label& label, const CommonOptions& options);

}  // namespace homolog::cli
