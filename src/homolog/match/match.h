// SPDX-License-Identifier: MIT
// Sec. 6: a correct set of correspondences with its warp, and the family of them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "homolog/base/vec.h"
#include "homolog/match/thin_plate_spline.h"
#include "homolog/salient/salient_point.h"

namespace homolog {

/// c = (x_i, x'_j): a pair of points held to be homologous.
struct Correspondence {
  int model = 0, data = 0;  ///< their places in Shape::points; data points beyond those are in Family::followed
  SalientPoint model_point, data_point;
  double descriptor_distance = 0;
  double confidence = 0;  ///< 0 to 1
};
using CorrespondenceSet = std::vector<Correspondence>;

/// Whether both points have a direction p, so that these can be compared.
inline bool has_directions(const Correspondence& c) { return c.model_point.direction_length > 0 && c.data_point.direction_length > 0; }
inline bool share_a_point(const Correspondence& p, const Correspondence& q) { return p.model == q.model || p.data == q.data; }

std::vector<Vec3> model_positions(const CorrespondenceSet& set);
std::vector<Vec3> data_positions(const CorrespondenceSet& set);

/// What the refined map tells about a match (evidence.h).
struct Evidence {
  double model_reached = 0;      ///< share of the model's skin that comes to lie on the data's, normals agreeing
  double data_near_reached = 0;  ///< share of the data's skin near it, along the inside, on which the model comes to lie
  double turning = 0;            ///< mean angle, in radians, between the rotations of neighbours: how much the body is bent all over
  double support = 0;            ///< number of salient points that the map pairs, each counted by how well it fits
  double ways_changed = 1;       ///< how much ways inside get longer here and shorter there: mean |log|, 1 at most (bending_invariants.h)
  double thickness_changed = 1;  ///< the same of the thickness
  double ends_missed = 0.3;      ///< mean distance of either shape's ends from the other's, in extents, 0.3 at most
};

enum class Handedness { proper, mirrored, ambiguous };
const char* handedness_name(Handedness handedness);

/// A correct set S (eq. 7 to 9), in the coordinates of the two files.
struct Match {
  CorrespondenceSet pairs;
  ThinPlateSpline data_from_model;  ///< f_S
  Similarity similarity;            ///< the similarity nearest to f_S
  Handedness handedness = Handedness::proper;
  double confidence = 0;  ///< that the match is right, 0 to 1
  double bending = 0;     ///< Delta of the spline through the pairs, without unit: energy / (scale^2 * model diagonal)
  double chamfer = 0;     ///< eq. 9: mean distance of the mapped covered part to the data / data diagonal
  Evidence evidence;
  double model_coverage = 0, data_coverage = 0;  ///< share of each shape's skin that the match explains
};

/// The length by which a match of parts is measured: the diagonal of the model mapped at this scale, at most the data's.
double matched_extent(double model_diagonal, double scale, double data_diagonal);

/// How many candidates each stage let through, in order; tells where the last one died.
struct StageCounts {
  std::vector<std::pair<std::string, long>> stages;
};

/// All matches, best first; empty when nothing was found.
struct Family {
  std::vector<Match> matches;
  StageCounts counts;
  std::vector<SalientPoint> followed;  ///< places in the data to which matches follow a model point; they go on the data's own points
};

}  // namespace homolog
