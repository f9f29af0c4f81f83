// SPDX-License-Identifier: MIT
// What calls return, as dicts whose keys are the fields of the classes in python/homolog/results.py.
#pragma once

#include <nanobind/nanobind.h>

#include "homolog/homolog.h"
#include "homolog/match/symmetry.h"
#include "homolog/match/transfer.h"

namespace homolog::python {

nanobind::dict points_fields(const std::vector<SalientPoint>& points);

/// The matches, best first, the counts of the stages, the followed points, and the sentence of doubt.
nanobind::tuple family_fields(const Family& family, const std::vector<MatchParts>& parts, const std::vector<MatchMap>& maps);

/// What each match of a shape with itself says.
nanobind::list symmetries_fields(const std::vector<Symmetry>& symmetries);

/// The class MatchMap, which carries points and pickles.
nanobind::class_<MatchMap> bind_match_map(nanobind::module_& module);

}  // namespace homolog::python
