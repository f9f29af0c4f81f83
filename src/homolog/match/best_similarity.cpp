// SPDX-License-Identifier: MIT
#include "homolog/match/best_similarity.h"

namespace homolog {

Similarity best_similarity(const std::vector<WeighedPair>& pairs, Chirality chirality) {
  double sum = 0;
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();
  for (const WeighedPair& pair : pairs) {
    sum += pair.weight;
    a += pair.weight * pair.from;
    b += pair.weight * pair.to;
  }
  Similarity s;
  if (!(sum > 0)) return s;
  a /= sum;
  b /= sum;
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
