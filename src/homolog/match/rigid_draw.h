// SPDX-License-Identifier: MIT
// Beyond the paper: the nearest similarity instead of a cloth, for a part that does not bend.
#pragma once

#include <vector>

#include "homolog/describe/shape.h"
#include "homolog/match/cloth.h"

namespace homolog {

/// The similarity near another one that lays the model's skin on the data's: rounds of best similarities to the tangent planes of the
/// nearest data samples (iterative closest points, Chen & Medioni 1992). Samples far from the data, as those of faces that a cut has left,
/// do not count. It stays as it is where less than twelve lie near.
Similarity settled_rigidly(Similarity laid, const std::vector<SurfaceSample>& model, const std::vector<SurfaceSample>& data);

/// The cloth laid by one similarity: the one nearest to it, then settled.
Cloth rigidly_drawn(const Cloth& cloth, const Shape& model, const Shape& data);

/// The similarity nearest to the map, over the skin. A spline's own is what is left when its bending is least: of another size if it bends.
Similarity similarity_of(const Cloth& cloth, const Body& body);

}  // namespace homolog
