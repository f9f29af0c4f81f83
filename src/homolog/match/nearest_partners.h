// SPDX-License-Identifier: MIT
// Closest points of two skins both ways, places that face away being farther.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace homolog {

/// Places and normals a coordinate a column, single precision being enough beside the skin's centre.
struct Facets {
  Eigen::ArrayX3f places, normals;
};

/// For each facet the number of the nearest one of the other skin (the first, of several), and the mean of its distance.
struct Partners {
  std::vector<int> of_model, of_data;
  double model_distance = 0, data_distance = 0;
};

/// A normal turned by a right angle counts as much as `turned_away`, in units of the places. Both have one facet at least.
Partners nearest_partners(const Facets& model, const Facets& data, double turned_away);

}  // namespace homolog
