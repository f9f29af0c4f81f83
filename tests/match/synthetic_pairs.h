// SPDX-License-Identifier: MIT
// Correspondences made in code: random salient points, a known similarity, true pairs among false ones.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <random>
#include <vector>

#include "homolog/match/match.h"

namespace homolog::synthetic {

inline double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
}

inline Vec3 in_cube(std::mt19937& random) {
  const double x = uniform(random, 0, 1), y = uniform(random, 0, 1), z = uniform(random, 0, 1);
  return {x, y, z};
}

inline std::vector<Vec3> points_in_cube(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(in_cube(random));
  return points;
}

inline SalientPoint salient_point(std::mt19937& random) {
  SalientPoint point;
  point.position = in_cube(random);
  point.radius = uniform(random, 0.03, 0.08);
  point.direction = (in_cube(random) - Vec3::Constant(0.5)).normalized();
  point.direction_length = 0.2;
  return point;
}

inline Similarity similarity(Chirality chirality, double scale) {
  Similarity s{scale, Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()).toRotationMatrix(), Vec3(3, -2, 5)};
  if (chirality == Chirality::mirrored) s.rotation = -s.rotation;
  return s;
}

// The image of a point, each coordinate wrong by up to `noise` radii and the direction by about as much.
inline SalientPoint image(const SalientPoint& point, const Similarity& map, double noise, std::mt19937& random) {
  SalientPoint moved = point;
  const Vec3 shaken = (in_cube(random) - Vec3::Constant(0.5)) * 2 * noise;
  moved.position = map(point.position + point.radius * shaken);
  moved.radius = map.scale * point.radius;
  moved.direction = (map.rotation * (point.direction + shaken)).normalized();
  return moved;
}

/// Pairs (i, i) of `truth` true points first, then false ones among all points until `count`.
inline std::vector<Correspondence> candidates(int truth, int count, const Similarity& map, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<SalientPoint> model, data;
  for (int i = 0; i < 2 * truth; ++i) {
    model.push_back(salient_point(random));
    data.push_back(image(i < truth ? model.back() : salient_point(random), map, noise, random));
  }
  std::vector<Correspondence> all;
  const auto add = [&](int i, int j, double descriptor_distance) { all.push_back({i, j, model[i], data[j], descriptor_distance, 0}); };
  for (int i = 0; i < truth; ++i) add(i, i, uniform(random, 0.2, 1));
  while (static_cast<int>(all.size()) < count) {
    const int i = random() % (2 * truth), j = random() % (2 * truth);
    if (i != j) add(i, j, uniform(random, 0.4, 1.5));
  }
  return all;
}

inline int count_true(const CorrespondenceSet& set) {
  return static_cast<int>(std::count_if(set.begin(), set.end(), [](const auto& c) { return c.model == c.data; }));
}

}  // namespace homolog::synthetic
