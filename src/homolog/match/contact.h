// SPDX-License-Identifier: MIT
// Whether a place on one skin comes to lie on another.
#pragma once

#include <vector>

#include "homolog/describe/body.h"
#include "homolog/describe/sample_blocks.h"
#include "homolog/describe/surface_samples.h"

namespace homolog {

/// Views of samples, the blocks they lie in, and the typical distance of neighbours.
struct Skin {
  const std::vector<SurfaceSample>& samples;
  const SampleBlocks& blocks;
  double spacing;
};

/// Samples with the blocks they lie in.
struct LaidSkin {
  std::vector<SurfaceSample> samples;
  SampleBlocks blocks;
  double spacing;

  Skin view() const { return {samples, blocks, spacing}; }
};

/// `order`: as make_blocks() takes it.
LaidSkin laid_skin(std::vector<SurfaceSample> samples, const std::vector<int>& order);

/// Whether the sample found nearest of the skin is not farther than `reach` along its normal, and the normals are within 60 degrees.
bool reaches(const SurfaceSample& sample, const NearestSample& found, const Skin& skin, double reach);

/// The same, which finds it.
bool reaches(const SurfaceSample& sample, const Skin& skin, double reach);

/// The skin node nearest to a sample, nearer than `farthest` and with a normal whose cosine with the sample's is above `agreement`; -1:
/// none.
int skin_node_at(const Body& body, const SurfaceSample& sample, double farthest, double agreement);

}  // namespace homolog
