// SPDX-License-Identifier: MIT
#include "homolog/describe/edges.h"

#include <Eigen/LU>
#include <Eigen/OrderingMethods>
#include <Eigen/Sparse>

namespace homolog {
namespace {

std::vector<int> elimination_order(const Edges& edges) {
  const int n = static_cast<int>(edges.square.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 1);
    for (int e = edges.first[i]; e < edges.first[i + 1]; ++e) entries.emplace_back(i, edges.other[e], 1);
  }
  Eigen::SparseMatrix<double> pattern(n, n);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::AMDOrdering<int>::PermutationType order;
  Eigen::AMDOrdering<int>()(pattern, order);
  return {order.indices().begin(), order.indices().end()};
}

}  // namespace

Edges edges_of(const std::vector<Vec3>& nodes, const std::vector<std::vector<int>>& neighbours) {
  const std::size_t count = nodes.size();
  Edges edges;
  edges.first.push_back(0);
  edges.sum.assign(count, Vec3::Zero());
  edges.square.assign(count, 0);
  edges.inverse.assign(count, Mat3::Zero());
  for (std::size_t i = 0; i < count; ++i) {
    Mat3 squares = Mat3::Zero();
    for (const int j : neighbours[i]) {
      const Vec3& edge = edges.vector.emplace_back(nodes[j] - nodes[i]);
      edges.other.push_back(j);
      edges.sum[i] += edge;
      edges.square[i] += edge.squaredNorm();
      squares += edge * edge.transpose();
    }
    if (edges.square[i] > 0) edges.inverse[i] = (squares + flat_share * edges.square[i] * Mat3::Identity()).inverse();
    edges.first.push_back(static_cast<int>(edges.other.size()));
  }
  edges.elimination = elimination_order(edges);
  return edges;
}

}  // namespace homolog
