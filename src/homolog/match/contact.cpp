// SPDX-License-Identifier: MIT
#include "homolog/match/contact.h"

#include <cmath>
#include <utility>

namespace homolog {

LaidSkin laid_skin(std::vector<SurfaceSample> samples, const std::vector<int>& order) {
  SampleBlocks blocks = make_blocks(samples, order);
  const double spacing = typical_spacing(positions_of(samples));
  return {std::move(samples), std::move(blocks), spacing};
}

bool reaches(const SurfaceSample& sample, const NearestSample& found, const Skin& skin, double reach) {
  if (found.sample < 0 || !(found.distance < reach + skin.spacing)) return false;
  const SurfaceSample& there = skin.samples[found.sample];
  return sample.normal.dot(there.normal) > 0.5 && std::abs((there.position - sample.position).dot(there.normal)) < reach;
}

bool reaches(const SurfaceSample& sample, const Skin& skin, double reach) {
  return reaches(sample, nearest_sample(skin.blocks, sample.position, reach + skin.spacing), skin, reach);
}

int skin_node_at(const Body& body, const SurfaceSample& sample, double farthest, double agreement) {
  int nearest = -1;
  double least = farthest * farthest;
  for (std::size_t i = 0; i < body.surface_count; ++i) {
    const double square = (body.nodes[i] - sample.position).squaredNorm();
    if (square < least && body.normals[i].dot(sample.normal) > agreement) least = square, nearest = static_cast<int>(i);
  }
  return nearest;
}

}  // namespace homolog
