// SPDX-License-Identifier: MIT
#include "homolog/match/rigid_draw.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "homolog/match/best_similarity.h"
#include "homolog/shape/nearest_points.h"

namespace homolog {
namespace {

constexpr std::size_t samples_of_a_round[] = {400, 400, 400, 400, 400, 400, 800, 1600, 1600};  // a prefix of the model's is even
constexpr std::size_t least_partners = 12;                                                     // some more than a similarity has unknowns
constexpr double most_distance = 2.5;                                                          // medians: farther samples have no partner
constexpr double least_agreement = 0.5;                                                        // of normals

// A laid model sample, and the tangent plane of the data sample nearest to it.
struct Partner {
  Vec3 place, normal;
  double height;  // of the place over the plane
};

// Without those whose normals disagree, and those much farther than most.
std::vector<Partner> partners(std::span<const SurfaceSample> model, const Similarity& laid, const std::vector<SurfaceSample>& data,
                              const NearestPoints& near) {
  std::vector<Partner> found;
  std::vector<double> distances;
  for (const SurfaceSample& sample : model) {
    const Vec3 place = laid(sample.position), normal = laid.rotation * sample.normal;
    const SurfaceSample& other = data[near.nearest(place, 1)[0].number];
    if (normal.dot(other.normal) < least_agreement) continue;
    found.push_back({place, other.normal, other.normal.dot(place - other.position)});
    distances.push_back(std::abs(found.back().height));
  }
  if (found.empty()) return found;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  std::erase_if(found, [limit = most_distance * *middle](const Partner& p) { return std::abs(p.height) > limit; });
  return found;
}

// The small similarity that moves the places on to their planes, to first order: x -> x + w x (x - m) + c (x - m) + t about their middle m.
Similarity step_to_planes(const std::vector<Partner>& partners) {
  Vec3 middle = Vec3::Zero();
  for (const Partner& p : partners) middle += p.place / static_cast<double>(partners.size());
  Eigen::Matrix<double, 7, 7> squares = Eigen::Matrix<double, 7, 7>::Zero();
  Eigen::Matrix<double, 7, 1> right = Eigen::Matrix<double, 7, 1>::Zero();
  for (const Partner& p : partners) {
    const Vec3 arm = p.place - middle;
    Eigen::Matrix<double, 7, 1> row;
    row << arm.cross(p.normal), arm.dot(p.normal), p.normal;
    squares += row * row.transpose();
    right -= p.height * row;
  }
  squares.diagonal() *= 1 + 1e-6;  // a body of revolution may turn freely
  const Eigen::Matrix<double, 7, 1> step = squares.ldlt().solve(right);
  const Vec3 turn = step.head<3>(), shift = step.tail<3>();
  Similarity moved;
  moved.scale = std::exp(step[3]);
  if (turn.norm() > 0) moved.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  moved.shift = middle + shift - moved.scale * (moved.rotation * middle);
  return moved;
}

}  // namespace

Similarity similarity_of(const Cloth& cloth, const Body& body) {
  std::vector<WeighedPair> pairs;
  for (std::size_t i = 0; i < body.surface_count; ++i) pairs.push_back({body.nodes[i], cloth.nodes[i], 1});
  return best_similarity(pairs, cloth.chirality);
}

Similarity settled_rigidly(Similarity laid, const std::vector<SurfaceSample>& model, const std::vector<SurfaceSample>& data) {
  if (data.empty()) return laid;
  const NearestPoints near(positions_of(data));
  for (const std::size_t most : samples_of_a_round) {
    const std::vector<Partner> found = partners(std::span(model).first(std::min(most, model.size())), laid, data, near);
    if (found.size() < least_partners) break;
    const Similarity step = step_to_planes(found);
    laid = {step.scale * laid.scale, step.rotation * laid.rotation, step(laid.shift)};
  }
  return laid;
}

Cloth rigidly_drawn(const Cloth& cloth, const Shape& model, const Shape& data) {
  const Similarity laid = settled_rigidly(similarity_of(cloth, model.body), model.surface, data.surface);
  std::vector<Vec3> places;
  for (const Vec3& node : model.body.nodes) places.push_back(laid(node));
  return lay_cloth(model.body, std::move(places), laid, cloth.chirality);
}

}  // namespace homolog
