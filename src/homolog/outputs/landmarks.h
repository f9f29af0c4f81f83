// SPDX-License-Identifier: MIT
// Landmarks as CSV and as 3D Slicer markups (.mrk.json, schema 1.0.3). Corresponding points carry the same label.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "homolog/describe/shape.h"
#include "homolog/match/match.h"

namespace homolog {

struct Landmark {
  std::string label;
  SalientPoint point;
  std::optional<double> confidence;  ///< of the pair; none for a point that is matched with nothing
};

/// The pairs of a match on the side of the model / of the data, in the same order with the same labels L001, L002, ...
std::vector<Landmark> model_landmarks(const Match& match);
std::vector<Landmark> data_landmarks(const Match& match);

/// All salient points of a shape, labelled P001, P002, ...
std::vector<Landmark> point_landmarks(const Shape& shape);

/// label,x,y,z,radius,direction_x,direction_y,direction_z,response,confidence; what is not known stays empty.
std::string landmarks_csv(const std::vector<Landmark>& landmarks);

/// As in markups_text().
std::string landmarks_markups(const std::vector<Landmark>& landmarks, bool ras = false);

}  // namespace homolog
