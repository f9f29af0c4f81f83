// SPDX-License-Identifier: MIT
// Beyond the paper: points carried from one shape to the other by the warp of a match, each with how far it can be trusted.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "homolog/match/coverage.h"
#include "homolog/shape/mesh.h"

namespace homolog {

/// Even samples of a surface and how surely each lies in the covered part (coverage.h).
struct CoveredSamples {
  std::vector<Vec3> positions;
  std::vector<float> weights;
  std::optional<Box> box;  ///< PartWeights::box
};

/// The model's point of a pair: there the map is known, as surely as the pair is.
struct KnownPlace {
  Vec3 position;
  double confidence;
};

/// A match, as far as carrying points needs it.
struct MatchMap {
  ThinPlateSpline data_from_model;
  std::vector<KnownPlace> known;
  double scale = 1;
  Mat4 similarity = Mat4::Identity();  ///< data_from_model as far as a similarity can tell, of homogeneous columns
  double model_diagonal = 0, data_diagonal = 0;
  double thickness = 0;        ///< that both surfaces were given, in diagonals: samples lie half of it off them
  double confidence = 1;       ///< that the match is right, 0 to 1
  CoveredSamples model, data;  ///< empty: which part is covered is not known
};

/// The matches of a family, each with the covered samples of `parts` (covered_parts()).
std::vector<MatchMap> match_maps(const std::vector<Match>& matches, const Shape& model, const Shape& data,
                                 const std::vector<MatchParts>& parts);

/// Whether the map turns right-handed into left-handed.
Chirality chirality_of(const MatchMap& match);

/// The triangles of a mesh that the map carries, either way: turned over where it mirrors, so that the outer side stays outside.
std::vector<Triangle> carried_triangles(const MatchMap& match, const Mesh& mesh);

enum class Direction { data_from_model, model_from_data };

struct CarriedPoint {
  Vec3 position;                   ///< where the map puts it
  bool exact = true;               ///< false, backwards, where the map folds and has no inverse: then `position` is but near
  double expected_error = 0;       ///< true errors are larger as often as smaller, if the match is right; unit of the shape carried to
  std::optional<double> coverage;  ///< how surely the point belongs to the covered part, 0 to 1; none if that is not known

  bool is_covered() const { return coverage.value_or(1) >= 0.5; }

  /// Whether it can be told at all: a point that is not is missing on the other shape, whatever the map says.
  bool is_there() const { return exact && is_covered(); }
};

/// Carries points, on the surface or off it. Backwards it is the inverse of the same map (Newton's method), so that points come back to
/// where they were.
std::vector<CarriedPoint> carry_points(const MatchMap& match, const std::vector<Vec3>& points, Direction direction);

/// How surely x belongs to the covered part: the mean weight of the nearest samples by inverse square distance, fading from .1 to .2
/// diagonals away from them; 0 outside their box. Needs at least one sample.
double coverage_at(const CoveredSamples& samples, double diagonal, const Vec3& x);

struct InversePlace {
  Vec3 position;
  bool exact;
};

/// f at its own centres.
std::vector<Vec3> images_of_centres(const ThinPlateSpline& f);

/// x with f(x) = y by Newton's method from the centre with the nearest image; not exact where it finds none and stays as near as it came.
/// `images`: images_of_centres(f); `scale`: of the map as a whole.
InversePlace inverse_at(const ThinPlateSpline& f, const std::vector<Vec3>& images, double scale, const Vec3& y);

/// How little is known of the map at x: the least of ((d + .02)^2 (1.01 - c) / c)^(1/3) over the known places, d their distance as a share
/// of the matched extent (`extent`, in the model's unit), c their confidence; at most .5.
double doubt_at(const std::vector<KnownPlace>& known, const Vec3& x, double extent);

/// Median error to expect at a point, as a share of the matched extent: .3 sqrt(a + .05) times the doubt there. a, the logarithm of the
/// ratio of the gradient's largest and smallest singular value, is how far the map is from any similarity. Fitted to matches with known
/// truth; docs/accuracy.md tells how it holds (bench/transfer.cpp).
double expected_error_share(const Mat3& gradient, double doubt);

}  // namespace homolog
