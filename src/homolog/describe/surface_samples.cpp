// SPDX-License-Identifier: MIT
#include "homolog/describe/surface_samples.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "homolog/base/parallel.h"
#include "homolog/describe/farthest_points.h"
#include "homolog/shape/nearest_points.h"

namespace homolog {
namespace {

constexpr std::size_t crowd = 16000;  // farthest-point sampling looks at no more surface voxels than this

// Multiplicative hashing spreads the choice over the grid without a random generator.
std::uint32_t scattered(std::size_t index) { return static_cast<std::uint32_t>(index) * 2654435761u; }

// Voxels of row (j, k) that are inside and have a neighbour that is not, or none.
template <class Visit>
void visit_surface_of_row(const Interior& interior, int j, int k, const Visit& visit) {
  const auto& [nx, ny, nz] = interior.frame.size;
  const bool on_border = j == 0 || k == 0 || j + 1 == ny || k + 1 == nz;
  const float* row = &interior.at(0, j, k);
  const std::ptrdiff_t y = nx, z = y * ny;
  for (int i = 0; i < nx; ++i) {
    if (row[i] < 0.5f) continue;
    const float* v = row + i;
    if (on_border || i == 0 || i + 1 == nx || v[-1] < 0.5f || v[1] < 0.5f || v[-y] < 0.5f || v[y] < 0.5f || v[-z] < 0.5f || v[z] < 0.5f) {
      visit(i);
    }
  }
}

std::vector<Eigen::Vector3f> surface_voxels(const Interior& interior) {
  struct Voxel {
    std::uint32_t hash;
    int i, j, k;
    bool operator<(const Voxel& other) const { return hash < other.hash; }
  };
  std::vector<Voxel> all;
  for (int k = 0; k < interior.frame.size[2]; ++k) {
    for (int j = 0; j < interior.frame.size[1]; ++j) {
      visit_surface_of_row(interior, j, k, [&](int i) { all.push_back({scattered(interior.frame.index(i, j, k)), i, j, k}); });
    }
  }
  const std::size_t chosen = std::min(crowd, all.size());
  const auto end = all.begin() + static_cast<std::ptrdiff_t>(chosen);
  if (end != all.end()) std::nth_element(all.begin(), end, all.end());
  std::sort(all.begin(), end);
  std::vector<Eigen::Vector3f> voxels;
  for (std::size_t n = 0; n < chosen; ++n) voxels.emplace_back(all[n].i, all[n].j, all[n].k);
  return voxels;
}

// The voxel farthest from the middle of all.
std::size_t outermost(const std::vector<Eigen::Vector3f>& voxels) {
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& voxel : voxels) middle += voxel;
  middle /= static_cast<float>(voxels.size());
  const auto farther = [&](const auto& a, const auto& b) { return (a - middle).squaredNorm() < (b - middle).squaredNorm(); };
  return static_cast<std::size_t>(std::max_element(voxels.begin(), voxels.end(), farther) - voxels.begin());
}

// Weights of a Gaussian of one voxel at 5 x 5 x 5 voxels.
struct GradientStencil {
  std::array<Eigen::Vector3i, 125> offsets;
  std::array<double, 125> weights;
  GradientStencil() {
    for (int n = 0; n < 125; ++n) {
      offsets[n] = Eigen::Vector3i(n % 5 - 2, n / 5 % 5 - 2, n / 25 - 2);
      weights[n] = std::exp(-0.5 * offsets[n].squaredNorm());
    }
  }
};

// Gradient of the coverage blurred by one voxel: differences along the axes alone saturate and lean towards the grid's diagonals.
Vec3 blurred_gradient(const Interior& interior, const Eigen::Vector3i& voxel) {
  static const GradientStencil stencil;
  Vec3 gradient = Vec3::Zero();
  for (int n = 0; n < 125; ++n) {
    const Eigen::Vector3i at = voxel + stencil.offsets[n];
    if (!interior.frame.contains(at.x(), at.y(), at.z())) continue;
    gradient += stencil.weights[n] * interior.at(at.x(), at.y(), at.z()) * stencil.offsets[n].cast<double>();
  }
  return interior.frame.axes * gradient;
}

// The gradient, and the place on it where coverage falls to one half, interpolated between the steps.
SurfaceSample settle(const Interior& interior, const Eigen::Vector3i& voxel) {
  const double h = interior.frame.spacing;
  const Vec3 voxel_centre = interior.frame.world_from_voxel(voxel.cast<double>());
  const Vec3 gradient = blurred_gradient(interior, voxel);
  if (gradient.norm() < 1e-3) return {voxel_centre, Vec3::Zero()};
  const Vec3 normal = -gradient.normalized();
  double way = 0, before = 0, inside = 1;
  for (int step = 0; step < 8; ++step) {
    const double here = sample(interior, voxel_centre + way * normal);
    if (here <= 0.5) {
      way = before + (way - before) * (inside - 0.5) / (inside - here);
      break;
    }
    inside = here;
    before = way;
    way += 0.25 * h;
  }
  return {voxel_centre + way * normal, normal};
}

}  // namespace

std::vector<SurfaceSample> sample_surface(const Interior& interior, int count) {
  const std::vector<Eigen::Vector3f> voxels = surface_voxels(interior);
  std::vector<SurfaceSample> samples;
  if (voxels.empty()) return samples;
  FarthestPoints order(voxels);
  FarthestPoint next{outermost(voxels), 1};
  while (static_cast<int>(samples.size()) < count && next.squared_distance > 0) {
    std::vector<std::size_t> batch;  // as many as are missing, to be settled side by side; few do not settle
    while (batch.size() + samples.size() < static_cast<std::size_t>(count) && next.squared_distance > 0) {
      batch.push_back(next.number);
      order.choose(next.number);
      next = order.farthest();
    }
    std::vector<SurfaceSample> settled(batch.size());
    parallel_for(batch.size(), [&](std::size_t n) { settled[n] = settle(interior, voxels[batch[n]].cast<int>()); });
    for (const SurfaceSample& sample : settled) {
      if (sample.normal.squaredNorm() > 0.5) samples.push_back(sample);
    }
  }
  return samples;
}

std::vector<Vec3> positions_of(const std::vector<SurfaceSample>& samples) {
  std::vector<Vec3> positions;
  for (const SurfaceSample& s : samples) positions.push_back(s.position);
  return positions;
}

double diagonal_of(const std::vector<SurfaceSample>& samples) {
  if (samples.empty()) return 0;
  Eigen::Matrix3Xd places(3, samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) places.col(static_cast<Eigen::Index>(i)) = samples[i].position;
  places.colwise() -= places.rowwise().mean().eval();
  const Mat3 axes = Eigen::SelfAdjointEigenSolver<Mat3>(places * places.transpose()).eigenvectors();
  const Eigen::Matrix3Xd along = axes.transpose() * places;
  return (along.rowwise().maxCoeff() - along.rowwise().minCoeff()).norm();
}

double typical_spacing(const std::vector<Vec3>& places) {
  if (places.size() < 2) return 0;
  const NearestPoints nearest(places);
  std::vector<double> squares(places.size());
  parallel_for(places.size(), [&](std::size_t i) { squares[i] = nearest.nearest(places[i], 2)[1].square_distance; });
  const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
  std::nth_element(squares.begin(), middle, squares.end());
  return std::sqrt(*middle);
}

}  // namespace homolog
