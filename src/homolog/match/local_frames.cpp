// SPDX-License-Identifier: MIT
#include "homolog/match/local_frames.h"

#include <algorithm>
#include <cmath>

#include "homolog/base/widest_clone.h"

namespace homolog {
namespace {

constexpr std::size_t lanes = 4;  // nodes at once

struct FourMatrices {
  FourDoubles column[3][3];
};

// The mean of every node's and its neighbours'.
std::vector<Mat3> smoothed(const std::vector<Mat3>& values, const Edges& edges) {
  std::vector<Mat3> means = values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (int e = edges.first[i]; e < edges.first[i + 1]; ++e) means[i] += values[edges.other[e]];
    means[i] /= 1 + edges.first[i + 1] - edges.first[i];
  }
  return means;
}

// Sum of image times rest over a node's edges, and of the images' squared lengths.
struct Spread {
  Mat3 covariance = Mat3::Zero();
  double square = 0;
};

// The nine sums stand apart: a matrix would be added to in memory, by vectors that wait for what single numbers have just stored there.
Spread spread_of(const Cloth& cloth, const Edges& edges, std::size_t i) {
  double xx = 0, xy = 0, xz = 0, yx = 0, yy = 0, yz = 0, zx = 0, zy = 0, zz = 0, square = 0;
  for (int e = edges.first[i]; e < edges.first[i + 1]; ++e) {
    const Vec3& here = cloth.nodes[i];
    const Vec3 &there = cloth.nodes[edges.other[e]], &rest = edges.vector[e];
    const double x = there.x() - here.x(), y = there.y() - here.y(), z = there.z() - here.z();
    xx += x * rest.x(), xy += x * rest.y(), xz += x * rest.z();
    yx += y * rest.x(), yy += y * rest.y(), yz += y * rest.z();
    zx += z * rest.x(), zy += z * rest.y(), zz += z * rest.z();
    square += x * x + y * y + z * z;
  }
  Spread spread;
  spread.covariance << xx, xy, xz, yx, yy, yz, zx, zy, zz;
  spread.square = square;
  return spread;
}

// Turns four rotations R to those nearest to the covariances C, starting where they stand (Mueller et al. 2016): each step by
// omega = sum of r_a x c_a / |sum of r_a . c_a| over their columns, which would be the angle times the axis. Taken as 2 t, t being the axis
// times the tangent of half the angle, it is the rotation by the quaternion (1, t), without a sine. Determinants stay.
HOMOLOG_WIDEST_CLONE void turn_towards(const FourMatrices& covariance, FourMatrices& rotation) {
  const FourDoubles none = {};
  auto unsettled = none == none;
  for (int step = 0; step < 12; ++step) {         // enough for nearly all; the others turn on in the next call
    FourDoubles t[3] = {}, grip = none + 1e-300;  // a place where all edges collapsed has none of either, and stays
    for (int a = 0; a < 3; ++a) {
      const auto &r = rotation.column[a], &c = covariance.column[a];
      for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        t[k] += r[l] * c[m] - r[m] * c[l];
        grip += r[k] * c[k];
      }
    }
    for (FourDoubles& component : t) component /= 2 * (grip < 0 ? -grip : grip);
    const FourDoubles square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];  // of half the angle's tangent
    unsettled &= square < 1e200;                                         // more is a grip of nothing, where no turn is better than another
    for (int a = 0; a < 3; ++a) {                                        // the rotation by (1, t) as a quaternion
      auto& r = rotation.column[a];
      const FourDoubles along = 2 * (t[0] * r[0] + t[1] * r[1] + t[2] * r[2]), still = 1 - square;
      const FourDoubles x[3] = {r[0], r[1], r[2]};
      for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        const FourDoubles turned = (still * x[k] + along * t[k] + 2 * (t[l] * x[m] - t[m] * x[l])) / (1 + square);
        r[k] = unsettled ? turned : x[k];
      }
    }
    unsettled &= square > 1e-6;  // a step leaves about the square of what it turned, 1e-6 radians
    bool any = false;
    for (std::size_t l = 0; l < lanes; ++l) any |= unsettled[l] != 0;
    if (!any) return;
  }
}

void turn_four(Mat3* rotations, const Spread* spreads, std::size_t count) {
  FourMatrices covariance = {}, rotation = {};
  for (std::size_t l = 0; l < count; ++l) {
    for (int a = 0; a < 3; ++a) {
      for (int k = 0; k < 3; ++k) {
        covariance.column[a][k][l] = spreads[l].covariance(k, a);
        rotation.column[a][k][l] = rotations[l](k, a);
      }
    }
  }
  turn_towards(covariance, rotation);
  for (std::size_t l = 0; l < count; ++l) {
    for (int a = 0; a < 3; ++a) {
      for (int k = 0; k < 3; ++k) rotations[l](k, a) = rotation.column[a][k][l];
    }
  }
}

}  // namespace

void fit_local_frames(Cloth& cloth, const Edges& edges, double give) {
  const std::size_t count = cloth.nodes.size();
  std::vector<Spread> spreads(count);
  for (std::size_t i = 0; i < count; ++i) spreads[i] = spread_of(cloth, edges, i);
  for (std::size_t i = 0; i < count; i += lanes) turn_four(&cloth.rotations[i], &spreads[i], std::min(lanes, count - i));
  std::vector<Mat3> stretch = cloth.rest;
  for (std::size_t i = 0; i < count; ++i) {
    if (edges.square[i] == 0) continue;
    const double measured = std::clamp(std::sqrt(spreads[i].square / edges.square[i]), 0.25 * cloth.scale, 4 * cloth.scale);
    cloth.scales[i] = std::sqrt(measured * cloth.scale);
    const Mat3 turned_back = cloth.rotations[i].transpose() * spreads[i].covariance;
    const Mat3 gradient = (turned_back + flat_share * edges.square[i] * cloth.scale * Mat3::Identity()) * edges.inverse[i];
    stretch[i] = (1 - give) * cloth.rest[i] + 0.5 * give * (gradient + gradient.transpose());
  }
  stretch = smoothed(stretch, edges);
  for (std::size_t i = 0; i < count; ++i) cloth.frames[i] = cloth.rotations[i] * stretch[i];
}

}  // namespace homolog
