// SPDX-License-Identifier: MIT
// Meshes made in code, so that the bench needs no data.
#pragma once

#include <vector>

#include "generate.h"

namespace homolog::bench {

/// A hand, a biplane and a quadruped.
std::vector<NamedMesh> example_meshes();

/// Heaps of boxes, rings, rods and balls, drawn by number; they look like nothing.
std::vector<NamedMesh> strangers(int count);

}  // namespace homolog::bench
