// SPDX-License-Identifier: MIT
// Pieces of a mesh whose triangles hang together, and which of them are to be turned.
#pragma once

#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog {

/// Triangles by where they lie along y and z: those that a ray along x can meet stand in one cell.
struct RayCells {
  std::size_t side = 0;          // cells along either axis
  std::vector<std::size_t> end;  // of each cell's triangles, which begin where those of the one before end
  std::vector<std::uint32_t> triangles;
};

struct Component {
  std::vector<std::uint32_t> triangles;
  RayCells cells;  // of the same, once something is looked for in it
  Box box;
  double volume = 0;
  bool solid = false;   // closed enough for its volume to have a sign
  bool turned = false;  // to be turned as a whole
};

/// Fills in box, volume and solid of a component whose triangles are known.
void measure(Component& component, const std::vector<Triangle>& triangles, const Mesh& mesh);

/// Turns reversed outermost solids together with everything in them, so that the cavities of a wholly reversed solid stay cavities.
void turn_components(std::vector<Component>& components, std::vector<Triangle>& triangles, const Mesh& mesh);

}  // namespace homolog
