// SPDX-License-Identifier: MIT
#include "homolog/match/match.h"

#include <algorithm>

namespace homolog {
namespace {

std::vector<Vec3> positions(const CorrespondenceSet& set, SalientPoint Correspondence::*side) {
  std::vector<Vec3> places;
  for (const Correspondence& c : set) places.push_back((c.*side).position);
  return places;
}

}  // namespace

std::vector<Vec3> model_positions(const CorrespondenceSet& set) { return positions(set, &Correspondence::model_point); }

std::vector<Vec3> data_positions(const CorrespondenceSet& set) { return positions(set, &Correspondence::data_point); }

double matched_extent(double model_diagonal, double scale, double data_diagonal) { return std::min(scale * model_diagonal, data_diagonal); }

const char* handedness_name(Handedness handedness) {
  switch (handedness) {
    case Handedness::proper:
      return "proper";
    case Handedness::mirrored:
      return "mirrored";
    case Handedness::ambiguous:
      break;
  }
  return "ambiguous";
}

}  // namespace homolog
