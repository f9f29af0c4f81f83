// SPDX-License-Identifier: MIT
#include "homolog/match/cloth.h"

#include <algorithm>
#include <cmath>

#include "homolog/match/local_frames.h"
#include "homolog/match/soft_assignment.h"
#include "homolog/match/solve_rows.h"

namespace homolog {
namespace {

constexpr double anchor_weight = 2;
constexpr int shape_steps = 2;  // rotations and places in turn, per assignment

// Soft assignment draws every skin inwards from its ends and edges, even one that lies where it should. What it would do to the skin laid
// on itself is given back, as in the Sinkhorn divergence (Feydy et al. 2019).
Pull unbiased_pull(const std::vector<SurfaceSample>& skin, const std::vector<int>& skin_order, const SampleBlocks& data, double reach,
                   const std::vector<LimbPlace>& limbs) {
  Pull pull = assign_softly(skin, data, reach, limbs);
  const Pull own = assign_softly(skin, make_blocks(skin, skin_order, limbs), reach, limbs);
  for (std::size_t i = 0; i < skin.size(); ++i) pull.places[i] += skin[i].position - own.places[i];
  return pull;
}

// A length or stiffness on its way from first to last.
double at_step(double first, double last, int step, int steps) {
  return steps == 1 ? last : first * std::pow(last / first, static_cast<double>(step) / (steps - 1));
}

// Nothing is drawn beyond the front, and little just before it. What lies beyond takes its share of the data all the same.
void hold_back(Pull& pull, const Body& model, const Front& front) {
  constexpr double blurred = 0.1;
  for (std::size_t i = 0; i < pull.masses.size(); ++i) {
    pull.masses[i] *= std::clamp((1 - model.ways(i, front.node) / front.way) / blurred, 0.0, 1.0);
  }
}

using Sparse = Eigen::SparseMatrix<double>;

// The upper half, rows and columns in the order of elimination.
Sparse laplacian_of(const Edges& edges) {
  const int n = static_cast<int>(edges.elimination.size());
  std::vector<int> rank(n);
  for (int k = 0; k < n; ++k) rank[edges.elimination[k]] = k;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(rank[i], rank[i], edges.first[i + 1] - edges.first[i]);
    for (int e = edges.first[i]; e < edges.first[i + 1]; ++e) {
      if (rank[i] < rank[edges.other[e]]) entries.emplace_back(rank[i], rank[edges.other[e]], -1);
    }
  }
  Sparse matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Where every node is drawn, and how strongly: by the data's samples, by anchors, and a trace to where it is. The stiffness of the edges
// stands here as a divisor, so that theirs is the Laplacian as it is.
struct Draw {
  Eigen::VectorXd mass;
  Eigen::MatrixX3d moment;  // mass times place
};

Draw draw_of(const Cloth& cloth, const Pull& pull, const std::vector<Anchor>& anchors, double stiffness) {
  constexpr double trace = 1e-9;
  const auto n = static_cast<Eigen::Index>(cloth.nodes.size());
  Draw draw{Eigen::VectorXd::Constant(n, trace), Eigen::MatrixX3d(n, 3)};
  for (Eigen::Index i = 0; i < n; ++i) draw.moment.row(i) = trace * cloth.nodes[i];
  const auto add = [&](std::size_t node, double mass, const Vec3& place) {
    draw.mass[node] += mass / stiffness;
    draw.moment.row(node) += mass / stiffness * place;
  };
  for (std::size_t i = 0; i < pull.masses.size(); ++i) add(i, pull.masses[i], pull.places[i]);
  for (const Anchor& anchor : anchors) add(anchor.node, anchor_weight, anchor.place);
  return draw;
}

// Laplacian of the rest shape laid by the local frames, and the draw: the edge e from i to j asks for (F_i + F_j) / 2 e (Sorkine & Alexa
// 2007, eq. 8, with frames for their rotations and all weights 1).
Eigen::MatrixX3d right_side(const Cloth& cloth, const Edges& edges, const Draw& draw) {
  Eigen::MatrixX3d right = draw.moment;
  for (std::size_t i = 0; i < cloth.nodes.size(); ++i) {
    Vec3 sum = cloth.frames[i] * edges.sum[i];
    for (int e = edges.first[i]; e < edges.first[i + 1]; ++e) sum += cloth.frames[edges.other[e]] * edges.vector[e];
    right.row(i) -= 0.5 * sum;
  }
  return right;
}

}  // namespace

ClothSchedule steps_of(const ClothSchedule& schedule, int begin, int end) {
  const auto reach = [&](int step) { return at_step(schedule.first_reach, schedule.last_reach, step, schedule.iterations); };
  const auto stiffness = [&](int step) { return at_step(schedule.first_stiffness, schedule.last_stiffness, step, schedule.iterations); };
  return {end - begin, reach(begin), reach(end - 1), stiffness(begin), stiffness(end - 1), schedule.give, schedule.front};
}

Cloth lay_cloth(const Body& model, const ThinPlateSpline& data_from_model, Chirality chirality) {
  std::vector<Vec3> places;
  for (const Vec3& node : model.nodes) places.push_back(data_from_model(node));
  return lay_cloth(model, std::move(places), data_from_model.similarity, chirality);
}

Cloth lay_cloth(const Body& model, std::vector<Vec3> places, const Similarity& similarity, Chirality chirality) {
  Cloth cloth;
  cloth.chirality = chirality;
  cloth.scale = similarity.scale;
  cloth.nodes = std::move(places);
  cloth.rotations.assign(model.nodes.size(), similarity.rotation);
  cloth.scales.assign(model.nodes.size(), cloth.scale);
  cloth.rest.assign(model.nodes.size(), cloth.scale * Mat3::Identity());
  cloth.frames.assign(model.nodes.size(), cloth.scale * similarity.rotation);
  fit_local_frames(cloth, model.edges);
  return cloth;
}

std::vector<SurfaceSample> mapped_skin(const Cloth& cloth, const Body& model) {
  std::vector<SurfaceSample> skin;
  for (std::size_t i = 0; i < model.surface_count; ++i) skin.push_back({cloth.nodes[i], cloth.rotations[i] * model.normals[i]});
  return skin;
}

void draw_cloth(Cloth& cloth, const Body& model, const std::vector<SurfaceSample>& data, double data_diagonal,
                const std::vector<Anchor>& anchors, const ClothSchedule& schedule, const LimbPlaces& limbs) {
  const SampleBlocks samples = make_blocks(data, limbs.data);
  const std::vector<int>& order = model.edges.elimination;
  const Sparse laplacian = laplacian_of(model.edges);
  Sparse system = laplacian;
  OrderedFactor solver;
  solver.analyzePattern(system);
  for (int step = 0; step < schedule.iterations; ++step) {
    const double reach = data_diagonal * at_step(schedule.first_reach, schedule.last_reach, step, schedule.iterations);
    const double stiffness = at_step(schedule.first_stiffness, schedule.last_stiffness, step, schedule.iterations);
    Pull pull = unbiased_pull(mapped_skin(cloth, model), model.skin_order, samples, reach, limbs.model);
    if (schedule.front) hold_back(pull, model, *schedule.front);
    const Draw draw = draw_of(cloth, pull, anchors, stiffness);
    system.diagonal() = laplacian.diagonal() + draw.mass(order);
    solver.factorize(system);
    for (int inner = 0; inner < shape_steps; ++inner) {
      PlaceRows places = PlaceRows::Zero(system.rows(), 4);
      places.leftCols<3>() = right_side(cloth, model.edges, draw)(order, Eigen::all);
      solve_rows(solver, places);
      for (std::size_t k = 0; k < order.size(); ++k) cloth.nodes[order[k]] = places.row(k).head<3>();
      fit_local_frames(cloth, model.edges, schedule.give);
    }
  }
}

}  // namespace homolog
