// SPDX-License-Identifier: MIT
#include "homolog/match/contact.h"

#include <cmath>

namespace homolog {

bool reaches(const SurfaceSample& sample, const NearestSample& found, const Skin& skin, double reach) {
  if (found.sample < 0 || !(found.distance < reach + skin.spacing)) return false;
  const SurfaceSample& there = skin.samples[found.sample];
  return sample.normal.dot(there.normal) > 0.5 && std::abs((there.position - sample.position).dot(there.normal)) < reach;
}

bool reaches(const SurfaceSample& sample, const Skin& skin, double reach) {
  return reaches(sample, nearest_sample(skin.blocks, sample.position), skin, reach);
}

}  // namespace homolog
