// SPDX-License-Identifier: MIT
// The whole way: a mesh becomes a Shape, two Shapes a Family of matches. Every stage can be called alone by its own header.
// A stopwatch, where one is given, gets a lap per stage.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "homolog/base/errors.h"
#include "homolog/base/parameters.h"
#include "homolog/base/stopwatch.h"
#include "homolog/describe/shape.h"
#include "homolog/match/match.h"
#include "homolog/shape/mesh.h"

namespace homolog {

/// Voxels, salient points and descriptors of a solid (Sec. 4 and 5). `part` limits it to a box given in shares of the mesh's
/// bounding box (0 to 1 per axis). Throws ShapeError when there is no inside or a vertex of a triangle is not there
/// or not finite, ParamError for values out of range.
Shape describe_shape(const Mesh& mesh, const Params& params = {}, const std::optional<Box>& part = {}, Stopwatch* watch = nullptr);

/// Every place where the model, or a part of it, occurs in the data (Sec. 6), best first, in the coordinates of the meshes. Empty when
/// nothing is found; `counts` tells after which stage. The same bytes for any number of threads. Both must have been described with these
/// parameters. Throws ParamError for values out of range, and for descriptors of different lengths.
Family match_shapes(const Shape& model, const Shape& data, const Params& params = {}, Stopwatch* watch = nullptr);

/// A shape against itself: its symmetries and repeated parts, the identity left out. Throws ParamError for values out of range.
Family find_symmetries(const Shape& shape, const Params& params = {}, Stopwatch* watch = nullptr);

}  // namespace homolog
