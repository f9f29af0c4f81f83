// SPDX-License-Identifier: MIT
#include "similarity.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>
#include <numbers>

namespace homolog::bench {
namespace {

Vec3 mean(const std::vector<Vec3>& points, const std::vector<double>& weights) {
  Vec3 sum = Vec3::Zero();
  double total = 0;
  for (std::size_t i = 0; i < points.size(); ++i) sum += weights[i] * points[i], total += weights[i];
  return sum / total;
}

// SplitMix64; the standard library's distributions differ between systems.
double next_unit(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15ull);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

std::uint64_t hash(const std::string& name) {
  std::uint64_t h = 0xcbf29ce484222325ull;
  for (const char c : name) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  return h;
}

// Shoemake's uniform unit quaternion.
Mat3 random_rotation(std::uint64_t& state) {
  const double u = next_unit(state), a = 2 * std::numbers::pi * next_unit(state), b = 2 * std::numbers::pi * next_unit(state);
  const double p = std::sqrt(1 - u), q = std::sqrt(u);
  return Eigen::Quaterniond(q * std::cos(b), p * std::sin(a), p * std::cos(a), q * std::sin(b)).toRotationMatrix();
}

}  // namespace

Similarity fit_similarity(const std::vector<Vec3>& model, const std::vector<Vec3>& data, bool mirrored, std::vector<double> weights) {
  if (weights.empty()) weights.assign(model.size(), 1);
  const Vec3 model_mean = mean(model, weights), data_mean = mean(data, weights);
  Mat3 covariance = Mat3::Zero();
  double variance = 0;
  for (std::size_t i = 0; i < model.size(); ++i) {
    covariance += weights[i] * (data[i] - data_mean) * (model[i] - model_mean).transpose();
    variance += weights[i] * (model[i] - model_mean).squaredNorm();
  }
  const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vec3 signs = Vec3::Ones();
  if ((svd.matrixU().determinant() * svd.matrixV().determinant() < 0) != mirrored) signs.z() = -1;
  Similarity fit;
  fit.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  fit.scale = variance > 0 ? svd.singularValues().dot(signs) / variance : 1;
  fit.shift = data_mean - fit.scale * (fit.rotation * model_mean);
  return fit;
}

double residual(const Similarity& similarity, const std::vector<Vec3>& model, const std::vector<Vec3>& data) {
  double sum = 0;
  for (std::size_t i = 0; i < model.size(); ++i) sum += (similarity(model[i]) - data[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(model.size()));
}

Similarity random_similarity(std::uint64_t seed, const std::string& name, double size) {
  std::uint64_t state = seed * 0x2545f4914f6cdd1dull ^ hash(name);
  Similarity random;
  random.rotation = random_rotation(state);
  random.scale = std::pow(10.0, 6 * next_unit(state) - 3);
  for (int axis = 0; axis < 3; ++axis) random.shift[axis] = 10 * size * random.scale * (2 * next_unit(state) - 1);
  return random;
}

}  // namespace homolog::bench
