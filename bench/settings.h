// SPDX-License-Identifier: MIT
// Parameters other than by default, as the benches' --param gives them.
#pragma once

#include <string>
#include <vector>

#include "homolog/base/parameters.h"

namespace homolog::bench {

/// Sets each NAME=VALUE. Throws ParamError for what is no such thing, or no parameter, or beyond its range.
void set_parameters(Params& params, const std::vector<std::string>& settings);

}  // namespace homolog::bench
