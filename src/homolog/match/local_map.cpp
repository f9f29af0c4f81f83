// SPDX-License-Identifier: MIT
#include "homolog/match/local_map.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "homolog/base/parallel.h"
#include "homolog/base/widest_clone.h"

namespace homolog {
namespace {

constexpr std::size_t lanes = 4;

struct FourPlaces {
  FourDoubles row[3];
};

struct FourMaps {
  FourDoubles position[3], gradient[3][3];
};

// The compiler takes roots side by side in a loop over memory, but not lane by lane.
[[gnu::always_inline]] inline void take_roots(FourDoubles& squares) {
  double in_memory[lanes];
  for (std::size_t l = 0; l < lanes; ++l) in_memory[l] = squares[l];
  for (double& square : in_memory) square = __builtin_sqrt(square);
  for (std::size_t l = 0; l < lanes; ++l) squares[l] = in_memory[l];
}

// The terms of all centres, in their order: as local_map() adds them, to the last bit.
HOMOLOG_WIDEST_CLONE void add_terms(const ThinPlateSpline& spline, const FourPlaces& x, FourMaps& sums) {
  FourMaps local = sums;
  const Vec3 *centres = spline.centres.data(), *weights = spline.weights.data();
  const FourDoubles zero = {};
  for (std::size_t k = 0; k < spline.centres.size(); ++k) {
    const double* c = centres[k].data();
    const double* w = weights[k].data();
    const FourDoubles way[3] = {x.row[0] - c[0], x.row[1] - c[1], x.row[2] - c[2]};
    const FourDoubles square = way[0] * way[0] + way[1] * way[1] + way[2] * way[2];
    FourDoubles distance = square;
    take_roots(distance);
    const bool r = spline.kernel == Kernel::r;
    const FourDoubles value = r ? distance : distance * distance * distance;
    const FourDoubles slope = r ? (distance > 0 ? 1 / distance : zero) : 3 * distance;
    for (int row = 0; row < 3; ++row) {
      local.position[row] += w[row] * value;
      const FourDoubles pull = slope * w[row];
      for (int column = 0; column < 3; ++column) local.gradient[row][column] += pull * way[column];
    }
  }
  sums = local;
}

void map_four(const ThinPlateSpline& spline, const Vec3* places, std::size_t count, LocalMap* maps) {
  FourPlaces x;
  FourMaps sums;
  for (std::size_t l = 0; l < lanes; ++l) {
    const Vec3& place = places[std::min(l, count - 1)];
    const Vec3 start = spline.affine.leftCols<3>() * place + spline.affine.col(3);
    for (int row = 0; row < 3; ++row) {
      x.row[row][l] = place[row];
      sums.position[row][l] = start[row];
      for (int column = 0; column < 3; ++column) sums.gradient[row][column][l] = spline.affine(row, column);
    }
  }
  add_terms(spline, x, sums);
  for (std::size_t l = 0; l < count; ++l) {
    for (int row = 0; row < 3; ++row) {
      maps[l].position[row] = sums.position[row][l];
      for (int column = 0; column < 3; ++column) maps[l].gradient(row, column) = sums.gradient[row][column][l];
    }
  }
}

}  // namespace

LocalMap local_map(const ThinPlateSpline& spline, const Vec3& x) {
  LocalMap local{spline.affine.leftCols<3>() * x + spline.affine.col(3), spline.affine.leftCols<3>()};
  for (std::size_t k = 0; k < spline.centres.size(); ++k) {
    const Vec3 way = x - spline.centres[k];
    const double distance = way.norm();
    if (!(distance > 0)) continue;
    const double slope = spline.kernel == Kernel::r ? 1 / distance : 3 * distance;  // of phi, over the distance
    local.position += spline.weights[k] * phi(spline.kernel, distance);
    local.gradient += (slope * spline.weights[k]) * way.transpose();
  }
  return local;
}

std::vector<LocalMap> local_maps(const ThinPlateSpline& spline, const std::vector<Vec3>& places) {
  std::vector<LocalMap> maps(places.size());
  parallel_for((places.size() + lanes - 1) / lanes, [&](std::size_t block) {
    const std::size_t first = lanes * block;
    map_four(spline, &places[first], std::min(lanes, places.size() - first), &maps[first]);
  });
  return maps;
}

Vec3 mapped_normal(const Mat3& gradient, const Vec3& normal) {
  Mat3 cofactors;  // det(J) J^-T, finite for a singular J
  for (int k = 0; k < 3; ++k) cofactors.col(k) = gradient.col((k + 1) % 3).cross(gradient.col((k + 2) % 3));
  return (gradient.determinant() < 0 ? -1 : 1) * (cofactors * normal).normalized();
}

}  // namespace homolog
