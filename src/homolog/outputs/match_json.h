// SPDX-License-Identifier: MIT
// `match.json`, format "homolog-match" version 1, and `points.json`, format "homolog-points" version 1.
// All coordinates are in the files' own units. No times, no absolute paths: bytes repeat. A point without direction has [0,0,0] there.
#pragma once

#include <string>

#include "homolog/homolog.h"

namespace homolog {

/// Parameters, both shapes with their points, counts and the whole family.
std::string match_json(const Shape& model, const Shape& data, const Family& family, const Params& params);

/// Parameters and one shape with its points, under the key "shape" as under "model" in match.json.
std::string points_json(const Shape& shape, const Params& params);

}  // namespace homolog
