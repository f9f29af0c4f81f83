// SPDX-License-Identifier: MIT
// Every vertex on the other mesh: dense maps, morphs, and attributes carried by them.
#pragma once

#include <nanobind/nanobind.h>

#include "homolog/match/transfer.h"

namespace homolog::python {

/// The methods dense, morph and transfer of MatchMap, and the functions between and write_morph.
void bind_dense(nanobind::module_& module, nanobind::class_<MatchMap>& map);

}  // namespace homolog::python
