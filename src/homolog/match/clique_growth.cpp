// SPDX-License-Identifier: MIT
// Sec. 6.2.2. What a candidate adds to Delta depends on its residual and on its model point; the latter is worked out once per quadruple.
#include "homolog/match/clique_growth.h"

#include <algorithm>
#include <cmath>

#include "homolog/match/cliques.h"
#include "homolog/match/energy_increment.h"
#include "homolog/match/quadruples.h"
#include "homolog/match/thin_plate_spline.h"

namespace homolog {
namespace {

// Work in pairs of candidates compared and words of bits touched; about 30 ns each.
constexpr long budget_per_quadruple = 200'000;
constexpr long budget_for_all = 20'000'000;
constexpr std::size_t sets_per_quadruple = 3;  // the largest cliques; smaller ones seldom survive eq. 9

// x and its tip, divided by `unit`.
std::vector<Vec3> constraint_points(const SalientPoint& point, bool with_direction, double unit) {
  std::vector<Vec3> points{point.position / unit};
  if (with_direction) points.push_back(tip(point) / unit);
  return points;
}

struct Constraints {
  std::vector<Vec3> sources, targets;
};

// Of a set, in units of the model's diagonal and of its image in the data.
template <class Pairs>
Constraints constraints(const Pairs& pairs, double source_unit, double target_unit) {
  Constraints all;
  for (const Correspondence& c : pairs) {
    for (const Vec3& x : constraint_points(c.model_point, has_directions(c), source_unit)) all.sources.push_back(x);
    for (const Vec3& x : constraint_points(c.data_point, has_directions(c), target_unit)) all.targets.push_back(x);
  }
  return all;
}

// The length in the data that the model's diagonal is mapped to, from the spreads of the matched points.
template <class Pairs>
double data_unit(const Pairs& pairs, double model_diagonal) {
  Vec3 model_mean = Vec3::Zero(), data_mean = Vec3::Zero();
  for (const Correspondence& c : pairs) model_mean += c.model_point.position, data_mean += c.data_point.position;
  model_mean /= static_cast<double>(pairs.size()), data_mean /= static_cast<double>(pairs.size());
  double model_spread = 0, data_spread = 0;
  for (const Correspondence& c : pairs) {
    model_spread += (c.model_point.position - model_mean).squaredNorm();
    data_spread += (c.data_point.position - data_mean).squaredNorm();
  }
  return model_diagonal * std::sqrt(data_spread / model_spread);
}

// A model point as candidates use it: with its direction, or without since their data point has none.
struct ModelConstraint {
  int model;
  std::vector<Vec3> sources;
};

struct Candidates {
  std::vector<const Correspondence*> pairs;
  std::vector<int> constraint;  // of pairs[i], in `constraints`
  std::vector<ModelConstraint> constraints;
};

Candidates prepare(const std::vector<Correspondence>& candidates, double model_diagonal) {
  Candidates prepared;
  for (const Correspondence& c : candidates) {
    const auto sources = constraint_points(c.model_point, has_directions(c), model_diagonal);
    auto& all = prepared.constraints;
    auto same =
        std::find_if(all.begin(), all.end(), [&](const auto& m) { return m.model == c.model && m.sources.size() == sources.size(); });
    if (same == all.end()) same = all.insert(all.end(), {c.model, sources});
    prepared.pairs.push_back(&c);
    prepared.constraint.push_back(static_cast<int>(same - all.begin()));
  }
  return prepared;
}

// A candidate with Delta(Q + c) < t_Delta.
struct Compatible {
  const Correspondence* pair;
  int constraint;
  SmallRows residual;
  double energy;
};

std::vector<Compatible> compatible_candidates(const EnergyIncrement& spline, const std::vector<EnergyIncrement::Block>& blocks,
                                              const Quadruple& Q, const Candidates& candidates, double unit, double limit) {
  std::vector<Compatible> result;
  for (std::size_t i = 0; i < candidates.pairs.size(); ++i) {
    const Correspondence& c = *candidates.pairs[i];
    if (std::any_of(Q.pairs.begin(), Q.pairs.end(), [&](const auto& q) { return share_a_point(c, q); })) continue;
    const auto& block = blocks[candidates.constraint[i]];
    const auto targets = constraint_points(c.data_point, block.sources.size() == 2, unit);
    SmallRows residual = -block.predicted;
    for (std::size_t k = 0; k < targets.size(); ++k) residual.row(k) += targets[k].transpose();
    const double energy = spline.energy() + increment(block.precision, residual);  // Delta(Q + c)
    if (energy < limit) result.push_back({&c, candidates.constraint[i], residual, energy});
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.energy < b.energy; });
  return result;
}

// Edges where Delta(Q + c_p + c_q) < limit.
Graph compatibility_graph(const EnergyIncrement& spline, const std::vector<EnergyIncrement::Block>& blocks,
                          const std::vector<Compatible>& vertices, double limit) {
  Graph graph(static_cast<int>(vertices.size()));
  std::vector<std::vector<int>> members(blocks.size());
  for (int v = 0; v < graph.size(); ++v) members[vertices[v].constraint].push_back(v);
  for (std::size_t a = 0; a < blocks.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (members[a].empty() || members[b].empty()) continue;
      const SmallSquare precision = spline.joint_precision(blocks[a], blocks[b]);
      for (const int p : members[a]) {
        for (const int q : members[b]) {
          if (share_a_point(*vertices[p].pair, *vertices[q].pair)) continue;
          SmallRows residual(vertices[p].residual.rows() + vertices[q].residual.rows(), 3);
          residual << vertices[p].residual, vertices[q].residual;
          if (spline.energy() + increment(precision, residual) < limit) graph.connect(p, q);  // Delta(Q + c_p + c_q)
        }
      }
    }
  }
  return graph;
}

std::pair<int, int> key(const Correspondence& c) { return {c.model, c.data}; }
bool key_order(const Correspondence& a, const Correspondence& b) { return key(a) < key(b); }

// What is spent on growing so far.
struct Work {
  long left = budget_for_all;
  bool complete = true;
};

// Q with the largest cliques of its compatible candidates.
std::vector<CorrespondenceSet> grow(const Quadruple& Q, const Candidates& candidates, double model_diagonal, double limit, Work& work) {
  const double unit = data_unit(Q.pairs, model_diagonal);
  const Constraints points = constraints(Q.pairs, model_diagonal, unit);
  const EnergyIncrement spline(points.sources, points.targets);
  if (!(spline.energy() < limit)) return {};  // eq. 8
  std::vector<EnergyIncrement::Block> blocks;
  for (const ModelConstraint& m : candidates.constraints) blocks.push_back(spline.block(m.sources));
  const auto vertices = compatible_candidates(spline, blocks, Q, candidates, unit, limit);                       // step 1
  const Graph graph = compatibility_graph(spline, blocks, vertices, 2 * limit);                                  // step 2
  MaximalCliques found = maximal_cliques(graph, std::min(budget_per_quadruple, work.left), sets_per_quadruple);  // step 3
  work.left -= found.work + static_cast<long>(vertices.size() * vertices.size() / 2);
  work.complete = work.complete && found.complete;
  if (found.cliques.empty()) found.cliques.emplace_back();

  std::vector<CorrespondenceSet> sets;
  for (const auto& clique : found.cliques) {
    CorrespondenceSet& S = sets.emplace_back(Q.pairs.begin(), Q.pairs.end());
    for (const int v : clique) S.push_back(*vertices[v].pair);
    std::sort(S.begin(), S.end(), key_order);
  }
  return sets;
}

bool inside_any(CorrespondenceSet set, const std::vector<CorrespondenceSet>& sets) {
  std::sort(set.begin(), set.end(), key_order);
  return std::any_of(sets.begin(), sets.end(),
                     [&](const auto& S) { return std::includes(S.begin(), S.end(), set.begin(), set.end(), key_order); });
}

}  // namespace

double affine_free_bending(const CorrespondenceSet& S, double model_diagonal) {
  const Constraints points = constraints(S, model_diagonal, data_unit(S, model_diagonal));
  return ThinPlateSpline::affine_free(points.sources, points.targets).energy;
}

GrownSets grow_quadruples(const std::vector<Correspondence>& candidates, double model_diagonal, const PaperParams& params) {
  const Quadruples seeds = find_quadruples(candidates, params.quadruples, params);
  GrownSets result{{}, seeds.consistent, 0, true};
  const Candidates prepared = prepare(candidates, model_diagonal);
  std::vector<CorrespondenceSet> found;
  Work work;
  for (const Quadruple& Q : seeds.best) {
    if (work.left <= 0) break;
    if (inside_any({Q.pairs.begin(), Q.pairs.end()}, found)) continue;
    ++result.grown;
    for (auto& S : grow(Q, prepared, model_diagonal, params.bending_limit, work)) found.push_back(std::move(S));
  }
  result.complete = seeds.complete && work.complete && work.left > 0;
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  for (auto& S : found) {
    if (!inside_any(S, result.sets)) result.sets.push_back(std::move(S));
  }
  return result;
}

}  // namespace homolog
