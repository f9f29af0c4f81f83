// SPDX-License-Identifier: MIT
#include "homolog/match/best_similarity.h"

namespace homolog {

Means means_of(const std::vector<WeighedPair>& pairs) {
  Means means;
  for (const WeighedPair& pair : pairs) {
    means.weight += pair.weight;
    means.from += pair.weight * pair.from;
    means.to += pair.weight * pair.to;
  }
  if (!(means.weight > 0)) return {};
  means.from /= means.weight;
  means.to /= means.weight;
  return means;
}

Similarity best_similarity(const std::vector<WeighedPair>& pairs, Chirality chirality) {
  const auto [a, b, sum] = means_of(pairs);
  Similarity s;
  if (!(sum > 0)) return s;
  Mat3 covariance = Mat3::Zero();
  double spread = 0;
  for (const WeighedPair& pair : pairs) {
    covariance += pair.weight / sum * (pair.to - b) * (pair.from - a).transpose();
    spread += pair.weight / sum * (pair.from - a).squaredNorm();
  }
  const Turn turn = nearest_turn(covariance, chirality);
  s.rotation = turn.rotation;
  if (spread > 0 && turn.trace > 0) s.scale = turn.trace / spread;
  s.shift = b - s.scale * (s.rotation * a);
  return s;
}

}  // namespace homolog
