// SPDX-License-Identifier: MIT
// A light graph of a solid: surface samples and salient points, joined where the way between them runs inside.
// Limbs that touch or stand close are not joined; opposite sides of a thin one are. Distances along it do not change when a body bends.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "homolog/describe/edges.h"
#include "homolog/describe/surface_samples.h"
#include "homolog/salient/salient_point.h"
#include "homolog/shape/volume.h"

namespace homolog {

struct Body {
  std::vector<Vec3> nodes;                   ///< surface samples first, then the salient points
  std::vector<Vec3> normals;                 ///< outward; zero at salient points
  std::vector<std::vector<int>> neighbours;  ///< symmetric
  std::size_t surface_count = 0;
  double spacing = 0;           ///< typical distance of neighbouring surface samples
  Eigen::MatrixXd ways;         ///< lengths of the shortest ways inside, node to node; infinite between separate pieces
  Edges edges;                  ///< between neighbours
  std::vector<int> skin_order;  ///< of the surface samples, in which blocks hold them (sample_blocks.h)

  std::size_t point_node(std::size_t point) const { return surface_count + point; }
};

/// Whether two nodes are neighbours on the skin: near, normals within 60 degrees, so not across a thin body.
bool neighbours_on_skin(const Body& body, int a, int b);

/// Joins the first `surface_count` samples and all points.
Body build_body(const Interior& interior, const std::vector<SurfaceSample>& samples, std::size_t surface_count,
                const std::vector<SalientPoint>& points);

/// Sets the edges and the order of the skin, once the nodes stand where they stay.
void settle_body(Body& body);

/// Lengths of the shortest ways inside from the nearest of the sources to all nodes; infinite between separate pieces.
std::vector<double> shortest_ways(const Body& body, const std::vector<int>& sources);

/// Lengths of the shortest ways inside the body between all salient points; infinite between separate pieces.
Eigen::MatrixXd inner_distances(const Body& body, const Interior& interior);

}  // namespace homolog
