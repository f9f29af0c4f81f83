// SPDX-License-Identifier: MIT
#include "homolog/match/nearest_partners.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "homolog/base/widest_clone.h"

namespace homolog {
namespace {

constexpr std::size_t lanes = 8;  // facets of the data at once
using EightInts [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = int;

constexpr float infinity = std::numeric_limits<float>::infinity();

struct Facet {
  float x, y, z, nx, ny, nz;
};

// Column after column, filled up to whole vectors by facets far away.
struct Columns {
  std::size_t count;
  std::vector<float> values;

  explicit Columns(const Facets& facets) : count((facets.places.rows() + lanes - 1) / lanes * lanes), values(6 * count, 0) {
    for (int c = 0; c < 3; ++c) {
      std::fill(values.begin() + c * count, values.begin() + (c + 1) * count, 1e18f);
      std::copy(facets.places.col(c).begin(), facets.places.col(c).end(), values.begin() + c * count);
      std::copy(facets.normals.col(c).begin(), facets.normals.col(c).end(), values.begin() + (3 + c) * count);
    }
  }
};

// The nearest so far, of eight facets a vector.
struct Nearest {
  std::vector<float> cost;
  std::vector<int> partner;

  explicit Nearest(std::size_t count) : cost(count, infinity), partner(count, 0) {}
};

// Facet i of the model beside all of the data: each of these may find its nearest, and eight of them are left as nearest to i.
HOMOLOG_WIDEST_CLONE void compare(const Facet& i, int number, const float* data, std::size_t count, float square, float* data_cost,
                                  int* data_partner, float* least, int* nearest) {
  EightFloats best = EightFloats{} + infinity;
  EightInts found = {}, here = {0, 1, 2, 3, 4, 5, 6, 7};
  for (std::size_t k = 0; k < count; k += lanes, here += static_cast<int>(lanes)) {
    const EightFloats x = eight(data + k) - i.x, y = eight(data + count + k) - i.y, z = eight(data + 2 * count + k) - i.z;
    const EightFloats agreement =
        eight(data + 3 * count + k) * i.nx + eight(data + 4 * count + k) * i.ny + eight(data + 5 * count + k) * i.nz;
    const EightFloats cost = x * x + y * y + z * z + square * (1 - agreement);
    found = cost < best ? here : found;
    best = cost < best ? cost : best;
    EightFloats& other = eight(data_cost + k);
    EightInts& partner = *reinterpret_cast<EightInts*>(data_partner + k);
    partner = cost < other ? EightInts{} + number : partner;
    other = cost < other ? cost : other;
  }
  eight(least) = best;
  *reinterpret_cast<EightInts*>(nearest) = found;
}

double mean_root(const std::vector<float>& squares, Eigen::Index count) {
  double sum = 0;
  for (Eigen::Index i = 0; i < count; ++i) sum += std::sqrt(std::max(0.0f, squares[i]));
  return sum / static_cast<double>(count);
}

}  // namespace

Partners nearest_partners(const Facets& model, const Facets& data, double turned_away) {
  const Columns columns(data);
  const auto square = static_cast<float>(turned_away * turned_away);
  const Eigen::Index model_count = model.places.rows(), data_count = data.places.rows();
  Nearest of_model(model_count), of_data(columns.count);
  for (Eigen::Index i = 0; i < model_count; ++i) {
    const auto x = model.places.row(i), n = model.normals.row(i);
    float least[lanes];
    int nearest[lanes];
    compare({x[0], x[1], x[2], n[0], n[1], n[2]}, static_cast<int>(i), columns.values.data(), columns.count, square, of_data.cost.data(),
            of_data.partner.data(), least, nearest);
    std::size_t first = 0;
    for (std::size_t l = 1; l < lanes; ++l) {
      if (std::pair(least[l], nearest[l]) < std::pair(least[first], nearest[first])) first = l;
    }
    of_model.cost[i] = least[first], of_model.partner[i] = nearest[first];
  }
  of_data.partner.resize(data_count);
  return {std::move(of_model.partner), std::move(of_data.partner), mean_root(of_model.cost, model_count),
          mean_root(of_data.cost, data_count)};
}

}  // namespace homolog
