// SPDX-License-Identifier: MIT
#include "homolog/match/contact.h"

#include <cmath>

namespace homolog {

bool reaches(const SurfaceSample& sample, const Skin& skin, double reach) {
  const NearestSample found = nearest_sample(skin.blocks, sample.position);
  if (found.sample < 0 || !(found.distance < reach + skin.spacing)) return false;
  const SurfaceSample& there = skin.samples[found.sample];
  return sample.normal.dot(there.normal) > 0.5 && std::abs((there.position - sample.position).dot(there.normal)) < reach;
}

}  // namespace homolog
