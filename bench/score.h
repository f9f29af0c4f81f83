// SPDX-License-Identifier: MIT
// Judges a family of matches by the truth. A reported pair is right when the truth carries the model point to within
// max(0.5 data radius, 0.05 data diagonal) of the data point; a point used twice is wrong; where the truth does not reach
// (far from all landmarks), a pair is not judged. A match is right with at least 4 right pairs of which 70 % of the judged are.
#pragma once

#include <string>
#include <vector>

#include "homolog/match/match.h"
#include "homolog/shape/mesh.h"
#include "truth.h"

namespace homolog::bench {

using Points = std::vector<SalientPoint>;

/// One match under both truths. The better truth counts; the direct one where they are equal.
struct MatchScore {
  int pairs = 0, judged = 0, right = 0;
  int right_direct = 0;
  bool success = false, success_direct = false;
  bool swapped = false;  ///< the swapped truth is the better one
};

/// Errors of the warp at the true points, as shares of the data diagonal.
struct TransferScore {
  double median = 0, mean = 0, within_05 = 0, within_10 = 0;
};

enum class Stage { points, family, ranking, ok };
const char* stage_name(Stage stage);

struct PairScore {
  std::string error;  ///< what was thrown instead of a result
  bool found = false, success = false, success_in_six = false, success_direct = false;
  MatchScore first;
  TransferScore transfer;
  std::vector<double> along_surface;  ///< errors at clicked landmarks, see errors_along_surface()
  double confidence = 0;
  Handedness handedness = Handedness::proper;
  bool handedness_right = false;  ///< proper or mirrored as the truth that the first match meets is
  bool has_swap = false;          ///< a swapped truth is known: the shape is left-right symmetric but for its pose
  int model_points = 0, data_points = 0, matches = 0;
  int findable = 0;                                               ///< model points with a true partner among the data points
  int findable_found = 0;                                         ///< of these, rightly paired by the first match
  int first_right = 0;                                            ///< rank of the first right match in the family, from 1; 0: none
  int instances = 0, instances_claimed = 0, instances_right = 0;  ///< see instances.h
  Stage lost = Stage::points;                                     ///< where the right answer was lost
};

MatchScore score_match(const Match& match, const Truth& truth, double data_diagonal);

TransferScore score_transfer(const ThinPlateSpline& data_from_model, const TrueMap& truth, double data_diagonal);

/// Where the warp puts landmarks, taken to the nearest place of the data surface: the ways from there to their true places along the
/// surface, as shares of the square root of its area (Kim et al. 2011).
std::vector<double> errors_along_surface(const ThinPlateSpline& data_from_model, const TrueMap& truth, const Mesh& data);

/// How many model points have a true partner: within the tolerance above, and a factor 1.65 of the radius to expect.
int count_findable(const Points& model, const Points& data, const TrueMap& truth, double data_diagonal);

PairScore score_family(const Family& family, const Points& model, const Points& data, const Truth& truth, double data_diagonal);

}  // namespace homolog::bench
