// SPDX-License-Identifier: MIT
#include "homolog/match/followed_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "homolog/describe/descriptors.h"
#include "homolog/match/contact.h"
#include "homolog/match/evidence.h"
#include "homolog/match/trusted_pairs.h"
#include "homolog/salient/direction.h"
#include "homolog/salient/response_at.h"

namespace homolog {
namespace {

constexpr std::size_t samples_around = 16;
constexpr double same_side = 0.3;  // cosine of normals that may be compared in thickness

// The skin nodes nearest to a point along the inside.
std::vector<int> skin_around(const Body& body, std::size_t node) {
  std::vector<int> order(body.surface_count);
  std::iota(order.begin(), order.end(), 0);
  const std::size_t count = std::min(samples_around, order.size());
  const auto way = [&](int skin) { return body.ways(static_cast<Eigen::Index>(node), skin); };
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                    [&](int a, int b) { return std::pair(way(a), a) < std::pair(way(b), b); });
  order.resize(count);
  return order;
}

// How the skin around a point comes to lie.
struct Surroundings {
  double reached = 0;            // share of it that lies on the data's skin
  double thickness_changed = 0;  // |mean log factor|, beyond the local scale
};

Surroundings surroundings(const std::vector<int>& skin, const std::vector<SurfaceSample>& laid, const Cloth& cloth, double extent,
                          const Shape& model, const Shape& data) {
  double reached = 0, factors = 0, compared = 0;
  for (const int node : skin) {
    const NearestSample there = nearest_sample(data.surface_blocks, laid[node].position);
    reached += reaches(laid[node], there, {data.surface, data.surface_blocks, data.surface_spacing}, reached_share * extent);
    if (there.sample < 0 || laid[node].normal.dot(data.surface[there.sample].normal) < same_side) continue;
    factors += std::log(data.thickness[there.sample] / (model.thickness[node] * cloth.scales[node]));
    ++compared;
  }
  return {reached / static_cast<double>(std::max<std::size_t>(1, skin.size())), compared > 0 ? std::abs(factors) / compared : 0};
}

// Way along the inside to the nearest point of a trusted pair, in extents, 1 at most.
double way_to_trusted(const CorrespondenceSet& trusted, int point, const Cloth& cloth, double extent, const Body& body) {
  double least = 1;
  for (const Correspondence& c : trusted) {
    least = std::min(least, body.ways(body.point_node(c.model), body.point_node(point)) * cloth.scale / extent);
  }
  return least;
}

}  // namespace

CorrespondenceSet followed_pairs(const CorrespondenceSet& rated, const Cloth& cloth, double merit, double extent, const Shape& model,
                                 const Shape& data) {
  const std::vector<SurfaceSample> laid = mapped_skin(cloth, model.body);
  const CorrespondenceSet trusted = trusted_pairs(rated);
  CorrespondenceSet pairs;
  for (int i = 0; i < static_cast<int>(model.points.size()); ++i) {
    if (std::any_of(rated.begin(), rated.end(), [&](const Correspondence& c) { return c.model == i; })) continue;
    const std::size_t node = model.body.point_node(i);
    const Surroundings around = surroundings(skin_around(model.body, node), laid, cloth, extent, model, data);
    const double way = way_to_trusted(trusted, i, cloth, extent, model.body);
    const double odds = -3.58 + 1.66 * merit + 2.0 * model.points[i].response - 0.32 * std::log(0.01 + way) + 1.84 * around.reached -
                        0.44 * around.thickness_changed - 1.95 * turning_at(cloth, model.body, static_cast<int>(node));
    SalientPoint place;
    place.position = cloth.nodes[node];
    place.radius = model.points[i].radius * cloth.scales[node];
    pairs.push_back({i, -1, model.points[i], place, 0, 1 / (1 + std::exp(-odds))});
  }
  return pairs;
}

void describe_followed(CorrespondenceSet& pairs, const Shape& model, const Shape& data, const Params& params) {
  std::vector<SalientPoint> points;
  for (const Correspondence& c : pairs) {
    if (c.data < 0) points.push_back(c.data_point);
  }
  find_directions(data.interior, params.salient, points);  // eq. 3
  const Descriptors descriptors = compute_descriptors(data.interior, points, params.descriptor);
  std::size_t next = 0;
  for (Correspondence& c : pairs) {
    if (c.data >= 0) continue;
    c.data_point = points[next];
    c.data_point.response = response_at(data.interior, c.data_point.position, c.data_point.radius, params.salient);
    c.descriptor_distance = descriptor_distance(model.descriptors[c.model], descriptors[next++], params.descriptor.kind);
  }
}

}  // namespace homolog
