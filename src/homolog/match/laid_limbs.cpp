// SPDX-License-Identifier: MIT
#include "homolog/match/laid_limbs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "homolog/match/contact.h"
#include "homolog/match/evidence.h"
#include "homolog/match/local_frames.h"

namespace homolog {
namespace {

constexpr double apart = 0.03;                        // extents between ends; nearer ones may be the same place of a tip
constexpr double other_length = 0.1;                  // log of how much longer or shorter a limb must be to be laid
constexpr double laid_share = 0.85;                   // of a limb, from its end
constexpr double blur = 0.12;                         // shares of a limb
constexpr double base_begins = 0.9, base_ends = 1.2;  // shares of a limb: where it branches off
constexpr std::size_t least_base = 3;                 // nodes that tell how much longer a limb is
constexpr double least_stretch = 0.4, most_stretch = 2.5;

// A limb of a body that lies somewhere: how far in on it every skin node is, 0 at its end and 1 where it branches off.
struct Limb {
  Eigen::ArrayXd in;
  Eigen::Matrix3Xd places;

  Vec3 middle(double share) const {
    const Eigen::ArrayXd weight = (-0.5 * ((in - share) / blur).square()).exp();
    return places * weight.matrix() / weight.sum();
  }
  Vec3 direction(double share) const { return middle(share + blur) - middle(share - blur); }
};

Limb limb_of(const Eigen::VectorXd& in, const std::vector<Vec3>& nodes, std::size_t skin) {
  Limb limb{in.head(static_cast<Eigen::Index>(skin)), Eigen::Matrix3Xd(3, skin)};
  for (std::size_t i = 0; i < skin; ++i) limb.places.col(static_cast<Eigen::Index>(i)) = nodes[i];
  return limb;
}

Mat3 turn_of(const Vec3& from, const Vec3& to) { return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix(); }

// `in` for all nodes of the model.
void lay_limb(Cloth& cloth, const Limb& wanted, const Eigen::VectorXd& in, std::size_t skin) {
  const Limb laid = limb_of(in, cloth.nodes, skin);
  const Mat3 whole = turn_of(laid.middle(1) - laid.middle(0), wanted.middle(1) - wanted.middle(0));
  for (std::size_t i = 0; i < cloth.nodes.size(); ++i) {
    const double share = in[static_cast<Eigen::Index>(i)];
    if (!(share < laid_share)) continue;
    const Mat3 turn = turn_of(whole * laid.direction(share), wanted.direction(share)) * whole;
    cloth.nodes[i] = wanted.middle(share) + turn * (cloth.nodes[i] - laid.middle(share));
    cloth.rotations[i] = turn * cloth.rotations[i];
  }
}

// How much longer than in the cloth at rest the way is in the data to end b, from where the limb branches off as the cloth lies: the
// median. 0: nothing tells.
double stretch_of(const Cloth& cloth, const Eigen::VectorXd& in, double length, int b, const Shape& model, const Shape& data) {
  std::vector<double> stretches;
  for (std::size_t i = 0; i < model.body.surface_count; ++i) {
    const double share = in[static_cast<Eigen::Index>(i)];
    if (!(share >= base_begins && share <= base_ends)) continue;
    const SurfaceSample laid{cloth.nodes[i], cloth.rotations[i] * model.body.normals[i]};
    const int node = skin_node_at(data.body, laid, std::numeric_limits<double>::infinity(), 0);
    const double way = node < 0 ? std::numeric_limits<double>::infinity() : data.ends.ways(node, b);
    if (std::isfinite(way)) stretches.push_back(way / (share * length * cloth.scale));
  }
  if (stretches.size() < least_base) return 0;
  const auto middle = stretches.begin() + static_cast<std::ptrdiff_t>(stretches.size() / 2);
  std::nth_element(stretches.begin(), middle, stretches.end());
  return std::clamp(*middle, least_stretch, most_stretch);
}

struct LimbToLay {
  std::size_t number;  // of its ends among the ends together
  double length, stretch;
};

// Those of the chosen ones that have a length in both bodies.
std::vector<LimbToLay> limbs_to_lay(const Cloth& cloth, const EndsTogether& together, const std::vector<std::size_t>& chosen,
                                    const Shape& model, const Shape& data) {
  const std::vector<double> lengths = limb_lengths(model.ends, together.model);
  std::vector<LimbToLay> limbs;
  for (const std::size_t k : chosen) {
    if (!is_length(lengths[k])) continue;
    const Eigen::VectorXd in = model.ends.ways.col(together.model[k]) / lengths[k];
    const double stretch = stretch_of(cloth, in, lengths[k], together.data[k], model, data);
    if (stretch > 0) limbs.push_back({k, lengths[k], stretch});
  }
  return limbs;
}

// Which way a value that is told for all nodes rises about one of them; zero where it does not.
Vec3 rise_at(std::size_t node, const Eigen::VectorXd& value, const Edges& edges) {
  Vec3 rise = Vec3::Zero();
  for (int e = edges.first[node]; e < edges.first[node + 1]; ++e) {
    const double step = value[edges.other[e]] - value[static_cast<Eigen::Index>(node)];
    if (std::isfinite(step)) rise += step * edges.vector[e];
  }
  return (edges.inverse[node] * rise).normalized();
}

// Along the limb alone, fading where it branches off. `owner` is the least share of a limb that a node has had.
void stretch_rest(Cloth& cloth, double stretch, const Eigen::VectorXd& in, const Edges& edges, std::vector<double>& owner) {
  for (std::size_t i = 0; i < cloth.nodes.size(); ++i) {
    const double share = in[static_cast<Eigen::Index>(i)];
    if (!(share < std::min(base_ends, owner[i]))) continue;
    owner[i] = share;
    const double fading = std::min(1.0, (base_ends - share) / (base_ends - 1));
    const Vec3 along = rise_at(i, in, edges);
    cloth.rest[i] = cloth.scale * (Mat3::Identity() + fading * (stretch - 1) * along * along.transpose());
  }
}

void lay(Cloth& cloth, const EndsTogether& together, const std::vector<LimbToLay>& limbs, const Shape& model, const Shape& data) {
  std::vector<double> owner(cloth.nodes.size(), std::numeric_limits<double>::infinity());
  for (const auto& [k, length, stretch] : limbs) {
    const Eigen::VectorXd in = model.ends.ways.col(together.model[k]) / length;
    const Eigen::VectorXd wanted = data.ends.ways.col(together.data[k]) / (stretch * length * cloth.scale);
    stretch_rest(cloth, stretch, in, model.body.edges, owner);
    lay_limb(cloth, limb_of(wanted, data.body.nodes, data.body.surface_count), in, model.body.surface_count);
  }
  fit_local_frames(cloth, model.body.edges);
}

}  // namespace

void lay_limbs(Cloth& cloth, const EndsTogether& together, const std::vector<std::size_t>& chosen, const Shape& model, const Shape& data) {
  lay(cloth, together, limbs_to_lay(cloth, together, chosen, model, data), model, data);
}

std::vector<Anchor> lay_limbs_of_other_length(Cloth& cloth, const Shape& model, const Shape& data) {
  const EndsTogether near = ends_together(cloth, model, data);
  std::vector<std::size_t> all(near.model.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<LimbToLay> limbs = limbs_to_lay(cloth, near, all, model, data);
  const auto model_end = [&](std::size_t k) { return static_cast<std::size_t>(model.ends.nodes[near.model[k]]); };
  const auto data_end = [&](std::size_t k) -> const Vec3& { return data.body.nodes[data.ends.nodes[near.data[k]]]; };
  const double limit = apart * extent_of(cloth, model, data);
  std::erase_if(limbs, [&](const LimbToLay& limb) {
    return std::abs(std::log(limb.stretch)) <= other_length ||
           (cloth.nodes[model_end(limb.number)] - data_end(limb.number)).norm() <= limit;
  });
  if (limbs.empty()) return {};
  lay(cloth, near, limbs, model, data);
  std::vector<Anchor> tips;
  for (const LimbToLay& limb : limbs) tips.push_back({model_end(limb.number), data_end(limb.number)});
  return tips;
}

}  // namespace homolog
