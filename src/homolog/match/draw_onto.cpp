// SPDX-License-Identifier: MIT
#include "homolog/match/draw_onto.h"

#include <algorithm>

#include "homolog/match/evidence.h"

namespace homolog {
namespace {

constexpr double near_share = 0.15;  // of the mapped model's extent

// The data's samples that the laid cloth can have to do with; the whole body's would draw parts apart.
std::vector<SurfaceSample> samples_near(const Cloth& cloth, const std::vector<SurfaceSample>& samples, double distance, std::size_t most) {
  std::vector<SurfaceSample> near;
  for (const SurfaceSample& s : samples) {
    const bool is_near = std::any_of(cloth.nodes.begin(), cloth.nodes.end(),
                                     [&](const Vec3& n) { return (n - s.position).squaredNorm() < distance * distance; });
    if (is_near) near.push_back(s);
    if (near.size() == most) break;
  }
  return near;
}

LimbPlaces limb_places_of(const EndsTogether& ends, const Shape& model, const Shape& data, const std::vector<SurfaceSample>& samples) {
  if (ends.model.empty()) return {};
  const auto skin = model.surface.begin() + static_cast<std::ptrdiff_t>(model.body.surface_count);
  return {limb_places({model.surface.begin(), skin}, model, ends.model), limb_places(samples, data, ends.data)};
}

}  // namespace

std::vector<Anchor> anchors_of(const CorrespondenceSet& pairs, const Body& model) {
  std::vector<Anchor> anchors;
  for (const Correspondence& c : pairs) anchors.push_back({model.point_node(c.model), c.data_point.position});
  return anchors;
}

void draw_onto(Cloth& cloth, const Shape& model, const Shape& data, const std::vector<Anchor>& anchors, const ClothSchedule& schedule,
               std::size_t most, const EndsTogether& ends) {
  const double extent = extent_of(cloth, model, data);
  const std::vector<SurfaceSample> near = samples_near(cloth, data.surface, near_share * extent, most);
  if (near.empty()) return;
  draw_cloth(cloth, model.body, near, extent, anchors, schedule, limb_places_of(ends, model, data, near));
}

}  // namespace homolog
