// SPDX-License-Identifier: MIT
// `match.json`, format "homolog-match" version 1, and `points.json`, format "homolog-points" version 1. No times, no absolute paths: bytes repeat.
#pragma once

#include <string>

#include "homolog/homolog.h"

namespace homolog {

std::string match_json(const Shape& model, const Shape& data, const Family& family, const Params& params);
std::string points_json(const Shape& shape, const Params& params);

}  // namespace homolog
