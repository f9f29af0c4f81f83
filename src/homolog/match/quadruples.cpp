// SPDX-License-Identifier: MIT
// App. A and B. Candidates with good descriptors come first, so that a search cut short has seen the likely quadruples.
#include "homolog/match/quadruples.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "homolog/match/cliques.h"

namespace homolog {
namespace {

constexpr long search_budget = 20'000'000;  // about 0.1 s; 400 candidates under pose need 1e5 to 1e6

std::vector<const Correspondence*> by_descriptor(const std::vector<Correspondence>& candidates) {
  std::vector<const Correspondence*> sorted;
  for (const Correspondence& c : candidates) sorted.push_back(&c);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto* a, const auto* b) { return a->descriptor_distance < b->descriptor_distance; });
  return sorted;
}

Graph pair_graph(const std::vector<const Correspondence*>& candidates, const PaperParams& params) {
  Graph graph(static_cast<int>(candidates.size()));
  for (int i = 0; i < graph.size(); ++i) {
    for (int j = 0; j < i; ++j) {
      if (pair_mismatch(*candidates[i], *candidates[j], params.pair_test) < params.pair_tolerance) graph.connect(i, j);
    }
  }
  return graph;
}

// 1/k(A): least over greatest stretch.
double inverse_condition(const Mat3& A) {
  const Vec3 stretches = Eigen::JacobiSVD<Mat3>(A).singularValues();
  return stretches[0] > 0 ? stretches[2] / stretches[0] : 0;
}

}  // namespace

double pair_mismatch(const Correspondence& p, const Correspondence& q, PairTest test) {
  if (share_a_point(p, q)) return std::numeric_limits<double>::infinity();
  const double d = (p.model_point.position - q.model_point.position).norm();
  const double d_data = (p.data_point.position - q.data_point.position).norm();
  const auto mismatch = [&](const Correspondence& c) {
    const double in_model = d / c.model_point.radius, in_data = d_data / c.data_point.radius;
    return std::abs(test == PairTest::printed ? in_model - in_data : std::log(in_model / in_data));
  };
  return std::max(mismatch(p), mismatch(q));  // App. A, w_ij
}

std::optional<Eigen::Matrix<double, 3, 4>> affine_map(const std::array<Correspondence, 4>& Q) {
  Mat3 model, data;  // edges from the first point
  for (int k = 0; k < 3; ++k) {
    model.col(k) = Q[k + 1].model_point.position - Q[0].model_point.position;
    data.col(k) = Q[k + 1].data_point.position - Q[0].data_point.position;
  }
  const double longest = model.colwise().norm().maxCoeff();
  if (std::abs(model.determinant()) <= 1e-9 * longest * longest * longest) return {};
  Eigen::Matrix<double, 3, 4> map;
  map.leftCols<3>() = data * model.inverse();  // App. A, A_Q
  map.col(3) = Q[0].data_point.position - map.leftCols<3>() * Q[0].model_point.position;
  return map;
}

double direction_mismatch(const std::array<Correspondence, 4>& Q, const Mat3& A, double unknown) {
  double worst = 0;
  for (const Correspondence& c : Q) {
    const Vec3 mapped = A * c.model_point.direction, p = c.data_point.direction;
    worst = std::max(worst, has_directions(c) ? std::atan2(mapped.cross(p).norm(), mapped.dot(p)) : unknown);  // App. A, d_a
  }
  return worst;
}

double quadruple_score(const std::array<Correspondence, 4>& Q, const PaperParams& params) {
  const auto map = affine_map(Q);
  if (!map) return 0;
  const Mat3 A = map->leftCols<3>();
  const double d_a = direction_mismatch(Q, A, params.direction_angle / 2);
  if (d_a >= params.direction_angle || inverse_condition(A) <= params.condition_min) return 0;
  double d_d = 0;
  for (const Correspondence& c : Q) d_d = std::max(d_d, c.descriptor_distance);  // eq. 7
  const double sigma_d = params.descriptor_spread;
  return std::exp(-d_d * d_d / (2 * sigma_d * sigma_d)) * (1 - d_a / params.direction_angle);  // App. B, epsilon, sign corrected
}

Quadruples find_quadruples(const std::vector<Correspondence>& candidates, std::size_t most, const PaperParams& params) {
  const auto sorted = by_descriptor(candidates);
  const FourCliques found = cliques_of_four(pair_graph(sorted, params), search_budget);
  const auto quadruple = [&](const std::array<int, 4>& v) {
    return std::array<Correspondence, 4>{*sorted[v[0]], *sorted[v[1]], *sorted[v[2]], *sorted[v[3]]};
  };

  std::vector<std::pair<double, std::size_t>> scored;  // values are copied for the best only: there may be a million cliques
  for (std::size_t i = 0; i < found.cliques.size(); ++i) {
    const double score = quadruple_score(quadruple(found.cliques[i]), params);
    if (score > 0) scored.emplace_back(-score, i);
  }
  std::sort(scored.begin(), scored.end());
  Quadruples result{{}, static_cast<long>(scored.size()), found.complete};
  scored.resize(std::min(scored.size(), most));
  for (const auto& [cost, i] : scored) result.best.push_back({quadruple(found.cliques[i]), -cost});
  return result;
}

}  // namespace homolog
