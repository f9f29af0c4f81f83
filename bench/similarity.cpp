// SPDX-License-Identifier: MIT
#include "similarity.h"

#include <Eigen/SVD>
#include <cmath>

#include "random.h"

namespace homolog::bench {
namespace {

Vec3 mean(const std::vector<Vec3>& points, const std::vector<double>& weights) {
  Vec3 sum = Vec3::Zero();
  double total = 0;
  for (std::size_t i = 0; i < points.size(); ++i) sum += weights[i] * points[i], total += weights[i];
  return sum / total;
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

Mesh moved(const Similarity& similarity, Mesh mesh) {
  for (Vec3& vertex : mesh.vertices) vertex = similarity(vertex);
  return mesh;
}

double residual(const Similarity& similarity, const std::vector<Vec3>& model, const std::vector<Vec3>& data) {
  double sum = 0;
  for (std::size_t i = 0; i < model.size(); ++i) sum += (similarity(model[i]) - data[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(model.size()));
}

Similarity random_similarity(std::uint64_t seed, const std::string& name, double size) {
  Random random(seed, name);
  Similarity drawn;
  drawn.rotation = random.rotation();
  drawn.scale = std::pow(10.0, random.between(-3, 3));
  for (int axis = 0; axis < 3; ++axis) drawn.shift[axis] = size * drawn.scale * random.between(-10, 10);
  return drawn;
}

}  // namespace homolog::bench
