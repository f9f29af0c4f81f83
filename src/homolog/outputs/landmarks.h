// SPDX-License-Identifier: MIT
// Landmarks as CSV and as 3D Slicer markups (.mrk.json, schema 1.0.x). Corresponding points carry the same label.
#pragma once

#include <string>
#include <vector>

#include "homolog/base/vec.h"
#include "homolog/describe/shape.h"
#include "homolog/match/match.h"

namespace homolog {

struct Landmark {
  std::string label;
  Vec3 position;
  double radius;
  double confidence;
};

/// The pairs of a match on the side of the model / of the data, in the same order with the same labels.
std::vector<Landmark> model_landmarks(const Match& match);
std::vector<Landmark> data_landmarks(const Match& match);
/// All salient points of a shape.
std::vector<Landmark> point_landmarks(const Shape& shape);

std::string landmarks_csv(const std::vector<Landmark>& landmarks);
/// The file's coordinates are taken as they are; "coordinateSystem" states LPS, Slicer's own default.
std::string landmarks_markups(const std::vector<Landmark>& landmarks);

}  // namespace homolog
