// SPDX-License-Identifier: MIT
#include "homolog/describe/surface_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace homolog {
namespace {

constexpr std::size_t crowd = 16000;  // farthest-point sampling looks at no more surface voxels than this

bool on_surface(const Interior& interior, int i, int j, int k) {
  if (interior.at(i, j, k) < 0.5f) return false;
  const int steps[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  return std::any_of(std::begin(steps), std::end(steps), [&](const int* s) {
    const int a = i + s[0], b = j + s[1], c = k + s[2];
    return !interior.frame.contains(a, b, c) || interior.at(a, b, c) < 0.5f;
  });
}

// Multiplicative hashing spreads the choice over the grid without a random generator.
std::uint32_t scattered(std::size_t index) { return static_cast<std::uint32_t>(index) * 2654435761u; }

std::vector<Vec3> surface_voxels(const Interior& interior) {
  std::vector<std::pair<std::uint32_t, Vec3>> all;
  const auto& size = interior.frame.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        if (on_surface(interior, i, j, k)) all.emplace_back(scattered(interior.frame.index(i, j, k)), Vec3(i, j, k));
      }
    }
  }
  const auto by_hash = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::sort(all.begin(), all.end(), by_hash);
  std::vector<Vec3> chosen;
  for (std::size_t n = 0; n < std::min(crowd, all.size()); ++n) chosen.push_back(all[n].second);
  return chosen;
}

// Gradient of the coverage blurred by one voxel: differences along the axes alone saturate and lean towards the grid's diagonals.
Vec3 blurred_gradient(const Interior& interior, const Vec3& voxel_centre) {
  Vec3 gradient = Vec3::Zero();
  for (int n = 0; n < 125; ++n) {
    const Vec3 offset(n % 5 - 2, n / 5 % 5 - 2, n / 25 - 2);
    gradient += std::exp(-0.5 * offset.squaredNorm()) * sample(interior, voxel_centre + interior.frame.spacing * offset) * offset;
  }
  return gradient;
}

// The gradient, and the place on it where coverage falls to one half.
SurfaceSample settle(const Interior& interior, const Vec3& voxel_centre) {
  const double h = interior.frame.spacing;
  const Vec3 gradient = blurred_gradient(interior, voxel_centre);
  if (gradient.norm() < 1e-3) return {voxel_centre, Vec3::Zero()};
  const Vec3 normal = -gradient.normalized();
  Vec3 place = voxel_centre;
  for (int step = 0; step < 8 && sample(interior, place) > 0.5f; ++step) place += 0.25 * h * normal;
  return {place, normal};
}

// Squared distances to the nearest chosen voxel, brought up to date; returns the farthest voxel.
Eigen::Index choose_next(const Eigen::MatrixX3f& voxels, Eigen::Index chosen, Eigen::ArrayXf& distance) {
  distance = distance.min((voxels.rowwise() - voxels.row(chosen)).rowwise().squaredNorm().array());
  Eigen::Index farthest = 0;
  distance.maxCoeff(&farthest);
  return farthest;
}

}  // namespace

std::vector<SurfaceSample> sample_surface(const Interior& interior, int count) {
  const std::vector<Vec3> places = surface_voxels(interior);
  std::vector<SurfaceSample> samples;
  if (places.empty()) return samples;
  Eigen::MatrixX3f voxels(places.size(), 3);  // in voxels, where single precision is exact
  for (std::size_t i = 0; i < places.size(); ++i) voxels.row(i) = places[i].cast<float>();
  Eigen::Index next = 0;
  (voxels.rowwise() - voxels.colwise().mean()).rowwise().squaredNorm().maxCoeff(&next);
  Eigen::ArrayXf distance = Eigen::ArrayXf::Constant(voxels.rows(), std::numeric_limits<float>::infinity());
  for (std::size_t tries = 0; tries < places.size() && static_cast<int>(samples.size()) < count; ++tries) {
    const SurfaceSample settled = settle(interior, interior.frame.world_from_voxel(places[next]));
    if (settled.normal.squaredNorm() > 0.5) samples.push_back(settled);
    next = choose_next(voxels, next, distance);
    if (distance[next] <= 0) break;
  }
  return samples;
}

}  // namespace homolog
