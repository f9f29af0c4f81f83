// SPDX-License-Identifier: MIT
// Coverage of voxels by parallel rays, layer by layer of voxels: exact along the ray, several rays per voxel across it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "homolog/shape/mesh.h"
#include "homolog/shape/ray_crossing.h"

namespace homolog {

/// Rays per voxel edge, 4 x 4 per voxel face.
inline constexpr int rays_per_voxel = 4;

/// A surface in grid coordinates: voxel i covers [i, i + 1].
struct GridSurface {
  std::array<int, 3> size;
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  Box part;  ///< only what is inside counts; within [0, size]

  std::size_t voxels() const { return static_cast<std::size_t>(size[0]) * size[1] * size[2]; }
};

/// What is summed per voxel along one axis when it is wholly inside.
inline constexpr int full_coverage = rays_per_voxel * rays_per_voxel << 16;

/// The rays' places along one direction across them: the middles of the voxels' shares that lie in the part, and how wide these are.
struct RayPlaces {
  std::vector<double> middle;  ///< behind the last, infinite ones
  std::vector<double> width;   ///< 1 when wholly in the part, 0 when outside
};

/// All rays along one axis. A layer is the voxels of one row along `axes.row`; the triangles that may come into layer i are
/// numbers[begin[i]] to numbers[begin[i + 1]].
struct RayBundle {
  RayAxes axes;
  RayPlaces columns, rows;
  std::vector<std::uint32_t> begin, numbers;
};

RayBundle make_bundle(const GridSurface& surface, int axis);

/// What the rays through one layer say. Coverage is told in whole numbers by its differences along the rays, so that it returns to
/// exactly 0 behind the solid.
struct Layer {
  std::size_t stride;                     ///< from row to row of the layer, in voxels; a row runs along x
  std::vector<std::int32_t> differences;  ///< to the voxel before, along the ray; of the rays that close
  std::vector<float> lost;                ///< per column of voxels: the share of its rays that do not close (0 to 1)
  bool any_lost;
};

/// Follows the rays of one layer after the other, with the same memory.
class LayerRays {
 public:
  LayerRays(const GridSurface& surface, const RayBundle& bundle);

  /// Adds the differences of a layer, where inside is where the winding number is not 0, and sets what is lost: a ray that enters and
  /// leaves unequally often passes a hole.
  void follow(int number, Layer& layer);

  /// A layer of zeros.
  Layer empty_layer() const;

 private:
  void find_crossings(int number);
  void add_ray(std::int32_t first, std::int32_t weight, std::size_t column, Layer& layer);

  const GridSurface& surface_;
  const RayBundle& bundle_;
  std::vector<std::int32_t> first_;   ///< crossing of each ray, row by row
  std::vector<std::int32_t> places_;  ///< of all crossings: depth in 1 / 65536 voxel, twice, and one more where the ray leaves
  std::vector<std::int32_t> next_;    ///< crossing of the same ray
  std::vector<std::int32_t> of_ray_;  ///< places of one ray's crossings
};

}  // namespace homolog
