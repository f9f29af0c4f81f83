// SPDX-License-Identifier: MIT
#include "homolog/match/turned_limbs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "homolog/match/evidence.h"
#include "homolog/match/local_frames.h"

namespace homolog {
namespace {

constexpr double most_spread = 0.13;  // extents: standard deviation of how much longer the ways from one end are
constexpr double distant = 0.1;       // of the distance between two ends counts beside the spread: the nearer of two like limbs
constexpr double laid_share = 0.85;   // of a limb, from its end
constexpr double blur = 0.12;         // shares of a limb

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

// How much longer the data's ways between the ends together are.
double scale_of_ways(const EndsTogether& together, const Ends& model, const Ends& data) {
  double here = 0, there = 0;
  for (std::size_t i = 0; i < together.model.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      here += way_between(model, together.model[i], together.model[j]);
      there += way_between(data, together.data[i], together.data[j]);
    }
  }
  return there / here;
}

// Standard deviation of how much longer the ways from b to the ends together are than those from a.
double spread(int a, int b, double scale, const EndsTogether& together, const Ends& model, const Ends& data) {
  const auto count = static_cast<Eigen::Index>(together.model.size());
  Eigen::ArrayXd longer(count);
  for (Eigen::Index i = 0; i < count; ++i)
    longer[i] = way_between(data, b, together.data[i]) - scale * way_between(model, a, together.model[i]);
  return std::sqrt((longer - longer.mean()).square().mean());
}

bool has(const std::vector<int>& values, int value) { return std::find(values.begin(), values.end(), value) != values.end(); }

struct Candidate {
  double cost;
  int a, b;
};

std::vector<Candidate> candidates_of(const EndsTogether& together, const Cloth& cloth, const Shape& model, const Shape& data) {
  const double extent = extent_of(cloth, model, data), scale = scale_of_ways(together, model.ends, data.ends);
  std::vector<Candidate> candidates;
  for (int a = 0; a < static_cast<int>(model.ends.nodes.size()); ++a) {
    for (int b = 0; b < static_cast<int>(data.ends.nodes.size()); ++b) {
      if (has(together.model, a) || has(together.data, b)) continue;
      const double ways = spread(a, b, scale, together, model.ends, data.ends) / extent;
      const double away = (cloth.nodes[model.ends.nodes[a]] - data.body.nodes[data.ends.nodes[b]]).norm() / extent;
      if (ways < most_spread) candidates.push_back({ways + distant * away, a, b});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) { return x.cost < y.cost; });
  return candidates;
}

}  // namespace

EndsTogether turned_ends(const EndsTogether& together, const Cloth& cloth, const Shape& model, const Shape& data) {
  EndsTogether turned;
  if (together.model.empty()) return turned;
  for (const Candidate& c : candidates_of(together, cloth, model, data)) {
    if (!has(turned.model, c.a) && !has(turned.data, c.b)) turned.model.push_back(c.a), turned.data.push_back(c.b);
  }
  return turned;
}

void lay_limbs(Cloth& cloth, const EndsTogether& together, std::size_t first, const Shape& model, const Shape& data) {
  const std::vector<double> here = limb_lengths(model.ends, together.model), there = limb_lengths(data.ends, together.data);
  for (std::size_t k = first; k < together.model.size(); ++k) {
    if (!is_length(here[k]) || !is_length(there[k])) continue;
    const Limb wanted = limb_of(data.ends.ways.col(together.data[k]) / there[k], data.body.nodes, data.body.surface_count);
    lay_limb(cloth, wanted, model.ends.ways.col(together.model[k]) / here[k], model.body.surface_count);
  }
  fit_local_frames(cloth, model.body.edges);
}

}  // namespace homolog
