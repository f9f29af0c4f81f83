// SPDX-License-Identifier: MIT
// A family as Python holds it: what was found, or read from a folder, and how it is written into one.
#pragma once

#include <nanobind/nanobind.h>

#include <optional>
#include <vector>

#include "homolog/homolog.h"
#include "homolog/match/coverage.h"
#include "homolog/match/symmetry.h"

namespace homolog::python {

/// What the files of a family tell beside what Python's own classes hold. Of the shapes only what is told of them.
struct Found {
  Params params;
  Shape model, data;
  Family family;
  std::optional<std::vector<Symmetry>> symmetries;  ///< of a shape against itself
};

/// What users take home of a family; `symmetries` of a shape against itself. While it is made other Python threads may work.
nanobind::tuple family_of(const MeshedShape& model, const MeshedShape& data, Family family, const Params& params, bool against_itself);

/// The class Found, which pickles, and the functions load and save.
void bind_found(nanobind::module_& module);

}  // namespace homolog::python
