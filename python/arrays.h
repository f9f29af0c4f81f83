// SPDX-License-Identifier: MIT
// The library's lists as arrays of numbers, which nanobind makes numpy's, and back.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "homolog/shape/mesh.h"

namespace homolog::python {

using Places = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Triangles = Eigen::Matrix<std::uint32_t, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// One row for each item: what `place` says of it.
template <class Items, class Place>
Places places_of(const Items& items, Place place) {
  Places rows(static_cast<Eigen::Index>(items.size()), 3);
  for (std::size_t i = 0; i < items.size(); ++i) rows.row(static_cast<Eigen::Index>(i)) = place(items[i]).transpose();
  return rows;
}

inline Places places_of(const std::vector<Vec3>& places) {
  return places_of(places, [](const Vec3& v) { return v; });
}

/// One value for each item: what `value` says of it.
template <class Items, class Value>
auto values_of(const Items& items, Value value) {
  Eigen::Matrix<decltype(value(items[0])), Eigen::Dynamic, 1> values(static_cast<Eigen::Index>(items.size()));
  for (std::size_t i = 0; i < items.size(); ++i) values[static_cast<Eigen::Index>(i)] = value(items[i]);
  return values;
}

inline std::vector<Vec3> vectors_of(const Places& rows) {
  std::vector<Vec3> vectors(static_cast<std::size_t>(rows.rows()));
  for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = rows.row(static_cast<Eigen::Index>(i)).transpose();
  return vectors;
}

inline Triangles triangles_of(const Mesh& mesh) {
  Triangles rows(static_cast<Eigen::Index>(mesh.triangles.size()), 3);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (int c = 0; c < 3; ++c) rows(static_cast<Eigen::Index>(i), c) = mesh.triangles[i][static_cast<std::size_t>(c)];
  }
  return rows;
}

/// What callers give may name vertices that are not there, which nothing after this asks again. Throws ShapeError.
inline Mesh mesh_of(const Places& vertices, const Triangles& triangles) {
  Mesh mesh{vectors_of(vertices), {}};
  for (Eigen::Index i = 0; i < triangles.rows(); ++i) mesh.triangles.push_back({triangles(i, 0), triangles(i, 1), triangles(i, 2)});
  check_mesh(mesh);
  return mesh;
}

}  // namespace homolog::python
