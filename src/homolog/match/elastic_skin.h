// SPDX-License-Identifier: MIT
// A surface that keeps its shape as far as it can while it is drawn somewhere: as rigid as possible (Sorkine & Alexa 2007), but for scale.
#pragma once

#include <Eigen/Sparse>
#include <vector>

#include "homolog/match/thin_plate_spline.h"
#include "homolog/shape/mesh.h"

namespace homolog {

/// Where the vertices are drawn to, and how strongly: 0 not at all.
struct VertexPull {
  std::vector<Vec3> targets;
  std::vector<double> weights;
};

/// Vertices in one place are one; a triangle counts by its area and its angles (cotangent weights, Pinkall & Polthier 1993), so that how a
/// face is cut does not matter.
class ElasticSkin {
 public:
  /// The mesh at rest; drawn it is expected to be `scale` times as large, or mirrored.
  ElasticSkin(const Mesh& rest, double scale, Chirality chirality);

  /// One step from `positions`: those that minimise the integral over the surface at rest, measured at `scale`, of
  /// w |x - target|^2 + length^2 |grad x - T|^2. T is the similarity by which the surface lies about a vertex now: its rotation, and the
  /// geometric mean of its scale and the whole's. `length`, in the unit of the positions, says how far a vertex drags others along.
  std::vector<Vec3> drawn(const std::vector<Vec3>& positions, const VertexPull& pull, double length) const;

 private:
  std::vector<Mat3> local_similarities(const std::vector<Vec3>& positions) const;
  /// What pulls each vertex, and what its neighbours want it to do.
  Eigen::MatrixX3d forces(const std::vector<Vec3>& positions, const VertexPull& pull, double length) const;

  std::vector<Vec3> rest_;
  double scale_;
  Chirality chirality_;
  std::vector<std::uint32_t> first_;       ///< of every vertex, the first one in its place
  Eigen::SparseMatrix<double> stiffness_;  ///< x' S x: the integral of |grad x|^2
  Eigen::VectorXd areas_;                  ///< of the surface about each vertex, at `scale`
};

}  // namespace homolog
