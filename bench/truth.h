// SPDX-License-Identifier: MIT
// What is true of a pair of shapes: where a point of the model, with its radius, lies in the data.
// In: true point pairs (the vertices of a dense truth, or a few landmarks). Out: a map of space near them.
// A left-right symmetric data shape has two right answers: the direct and the swapped one.
#pragma once

#include <optional>
#include <vector>

#include "similarity.h"

namespace homolog::bench {

/// The true point pairs as they are read, in the coordinates of the two meshes.
struct TruePoints {
  bool dense = true;      ///< surface vertices; else landmarks
  bool mirrored = false;  ///< the direct answer is a mirror image
  std::vector<Vec3> model, data;
  std::vector<Vec3> swapped_data;  ///< where the left-right swapped answer puts the model points; empty without a symmetry
};

/// Where the truth puts a model point, and how much larger things are there.
struct Placed {
  Vec3 position;
  double scale;
};

/// One right answer as a map.
struct TrueMap {
  bool dense = true, mirrored = false;
  std::vector<Vec3> model, data;
  Similarity whole;           ///< of all points
  std::vector<Vec3> weights;  ///< landmarks: kernel-r spline through what `whole` leaves over
  Vec3 constant = Vec3::Zero();
  double model_extent = 0, data_extent = 0;  ///< diagonals of the boxes around the points as they were before any turn
};

struct Truth {
  TrueMap direct;
  std::optional<TrueMap> swapped;

  const TrueMap& answer(bool of_swapped) const { return of_swapped ? *swapped : direct; }
};

/// The truth of the shapes turned so. Needs at least 4 true pairs; throws std::invalid_argument for fewer.
Truth make_truth(const TruePoints& points, const Similarity& model_turn = {}, const Similarity& data_turn = {});

/// Where a point inside the model lies in the data. Dense truth: the similarity of the true vertices within 1.5 radius, at least
/// the 12 nearest. Landmarks: the similarity that weighs near landmarks most; none where no landmark is near, or where a spline
/// through all landmarks says otherwise: there the landmarks do not tell.
std::optional<Placed> carry(const TrueMap& map, const Vec3& model_position, double model_radius);

}  // namespace homolog::bench
