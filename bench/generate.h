// SPDX-License-Identifier: MIT
// Cases with exact truth, made from any closed mesh: posed, changed, mirrored, cut, several in a scene, and pairs that share nothing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "run_cases.h"

namespace homolog::bench {

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

/// The cases of every mesh; the sets are the kinds of change. The strangers are the clutter of scenes and the partners that share
/// nothing with any mesh. `seed` draws planes, places and noise. Meshes that are inside out are turned over. Throws ShapeError for one that
/// is not closed, and ParamError where two have one name: shapes go by their names.
std::vector<Case> generated_cases(const std::vector<NamedMesh>& meshes, const std::vector<NamedMesh>& strangers, std::uint64_t seed);

}  // namespace homolog::bench
