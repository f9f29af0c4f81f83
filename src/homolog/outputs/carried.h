// SPDX-License-Identifier: MIT
// Carried points and meshes as files: CSV, 3D Slicer markups, PLY. A missing point keeps its label and its row, without coordinates.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "homolog/match/transfer.h"
#include "homolog/shape/mesh.h"

namespace homolog {

struct CarriedLandmark {
  std::string label;
  std::optional<CarriedPoint> point;  ///< none: it was missing already
};

/// label,x,y,z,expected_error,coverage; cells of what is missing or not known stay empty.
std::string carried_csv(const std::vector<CarriedLandmark>& landmarks);

/// Missing points have positionStatus "undefined"; the description tells expected error and coverage.
std::string carried_markups(const std::vector<CarriedLandmark>& landmarks);

/// The mesh with its vertices where `positions` are; properties `quality` (coverage, 1 if it is not known, 0 without an inverse) and
/// `expected_error`.
std::string carried_ply(const Mesh& mesh, const std::vector<CarriedPoint>& vertices);

}  // namespace homolog
