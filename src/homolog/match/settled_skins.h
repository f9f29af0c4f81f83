// SPDX-License-Identifier: MIT
// Beyond the paper: one skin laid on another by their principal axes, and settled there by closest points both ways.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "homolog/describe/surface_samples.h"
#include "homolog/match/growth.h"
#include "homolog/match/nearest_partners.h"

namespace homolog {

/// Up to 150 samples of a surface.
struct AxisSkin {
  Eigen::Matrix3Xd places, normals;
  Vec3 centre = Vec3::Zero();
  Mat3 axes = Mat3::Identity();  ///< columns, longest first
  double radius = 0;             ///< root mean square distance from the centre
  double diagonal = 0;           ///< of the box around the whole surface
  Facets facets;                 ///< beside the centre
};

/// Of the first samples, which must be even.
AxisSkin axis_skin(const std::vector<SurfaceSample>& surface, double diagonal);

/// The 24 similarities of one chirality that lay the axes of the model on those of the data, centre on centre and as large.
std::vector<Similarity> axis_similarities(const AxisSkin& model, const AxisSkin& data, Chirality chirality);

struct Settled {
  Similarity similarity;
  double distance = std::numeric_limits<double>::infinity();  ///< two-way mean, normals counted, in data diagonals
};

/// Closest points both ways and the best similarity, in turn.
Settled settle(const Similarity& start, const AxisSkin& model, const AxisSkin& data, Chirality chirality);

/// Up to `most` different ways to lay the axes on each other, settled, the nearest first.
std::vector<Settled> ways_to_lay(const AxisSkin& model, const AxisSkin& data, Chirality chirality, std::size_t most);

/// The distance before any settling, of the first 60 samples of each.
Settled rough_look(const Similarity& start, const AxisSkin& model, const AxisSkin& data);

/// Whether the two lay the model so that its places differ by less than .15 of the diagonal in the mean.
bool same_start(const Similarity& a, const Similarity& b, const AxisSkin& model, double diagonal);

/// A start without pairs.
GrownSet set_of(const Similarity& similarity, Chirality chirality);

}  // namespace homolog
