// SPDX-License-Identifier: MIT
// Surface samples in blocks of neighbours: blocks too far away are passed over whole, the others reckoned sixteen samples at a time.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <vector>

#include "homolog/describe/surface_samples.h"

namespace homolog {

constexpr int block_size = 16;
using BlockFloats = Eigen::Array<float, block_size, 1>;

/// Which limb a place belongs to and how far out it lies on it, 0 on the trunk, in a unit of the one who tells it.
struct LimbPlace {
  float limb = 0, out = 0;
};

struct SampleBlock {
  BlockFloats x, y, z;     ///< places, relative to SampleBlocks::middle; far away where the block is not full
  BlockFloats nx, ny, nz;  ///< normals
  BlockFloats limb, out;   ///< limb places
  std::array<int, block_size> sample;
};

/// A ball that holds all places of a block.
struct BlockBall {
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  float radius = 0;
};

/// Single precision suffices because places are relative to the middle.
struct SampleBlocks {
  std::vector<SampleBlock> blocks;
  std::vector<BlockBall> balls;  ///< of the blocks; apart from them, since most blocks are passed over by their ball alone
  Vec3 middle = Vec3::Zero();
};

/// The order of the samples in which blocks hold them, after halving them across their longest side until a block holds each piece.
std::vector<int> block_order(const std::vector<Vec3>& places);

/// Samples without limb places lie on the trunk. An order from where the samples lay before serves as long as neighbours stay neighbours.
SampleBlocks make_blocks(const std::vector<SurfaceSample>& samples, const std::vector<int>& order,
                         const std::vector<LimbPlace>& limb_places = {});
SampleBlocks make_blocks(const std::vector<SurfaceSample>& samples, const std::vector<LimbPlace>& limb_places = {});

/// Whether a place of the block may lie within a length of this one.
inline bool may_reach(const BlockBall& ball, const Eigen::Vector3f& place, float within) {
  const float passed = within + ball.radius;
  return (ball.centre - place).squaredNorm() <= passed * passed;
}

/// Squared distances from a place, relative to the middle, to the samples of a block.
BlockFloats squared_distances(const SampleBlock& block, const Eigen::Vector3f& place);

struct NearestSample {
  int sample = -1;  ///< -1: there is none
  double distance = 0;
};

/// None is told where all are farther than `within`.
NearestSample nearest_sample(const SampleBlocks& samples, const Vec3& place, double within = std::numeric_limits<double>::infinity());

}  // namespace homolog
