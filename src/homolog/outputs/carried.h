// SPDX-License-Identifier: MIT
// Carried points and meshes as files: CSV, PLY, and whatever writes points. A missing point keeps its label and its row, without
// coordinates.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "homolog/match/transfer.h"
#include "homolog/outputs/markups.h"
#include "homolog/shape/mesh.h"

namespace homolog {

struct CarriedLandmark {
  std::string label;
  std::optional<CarriedPoint> point;  ///< none: it was missing already
  std::string description = {};       ///< what the file that it is from says of it
  MarkupDisplay display = {};
};

/// Whether a file can hold where a point is carried and what error to expect there.
bool is_finite(const CarriedPoint& point);

/// label,x,y,z,expected_error,coverage; cells of what is missing or not known stay empty.
std::string carried_csv(const std::vector<CarriedLandmark>& landmarks);

/// Points for the formats that have no columns of their own for expected error and coverage: the description tells these behind what it
/// said before, in place of what an earlier transfer told there.
std::vector<MarkupPoint> carried_places(const std::vector<CarriedLandmark>& landmarks);

/// The mesh with its vertices where `positions` are; properties `quality` (coverage, 1 if it is not known, 0 without an inverse) and
/// `expected_error`.
std::string carried_ply(const Mesh& mesh, const std::vector<CarriedPoint>& vertices);

}  // namespace homolog
