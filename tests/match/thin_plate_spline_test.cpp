// SPDX-License-Identifier: MIT
// Sec. 6.1, against dense systems solved here and the laws of the two kernels.
#include "homolog/match/thin_plate_spline.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "match/synthetic_pairs.h"

namespace homolog {
namespace {

using Eigen::MatrixXd;
using synthetic::points_in_cube;

MatrixXd rows_of(const std::vector<Vec3>& points) {
  MatrixXd rows(points.size(), 3);
  for (std::size_t i = 0; i < points.size(); ++i) rows.row(i) = points[i].transpose();
  return rows;
}

MatrixXd kernel_matrix(const std::vector<Vec3>& points, double power) {
  MatrixXd K(points.size(), points.size());
  for (int i = 0; i < K.rows(); ++i) {
    for (int j = 0; j < K.cols(); ++j) K(i, j) = std::pow((points[i] - points[j]).norm(), power);
  }
  return K;
}

template <class Map>
std::vector<Vec3> mapped(const std::vector<Vec3>& points, const Map& map) {
  std::vector<Vec3> result;
  for (const Vec3& x : points) result.push_back(map(x));
  return result;
}

std::vector<Vec3> scaled(const std::vector<Vec3>& points, double factor) {
  return mapped(points, [=](const Vec3& x) -> Vec3 { return factor * x; });
}

ThinPlateSpline similarity_free(const std::vector<Vec3>& sources, const std::vector<Vec3>& targets, Chirality chirality = Chirality::proper,
                                double nugget = 0) {
  return ThinPlateSpline::similarity_free(SourceSystem(sources, std::vector<double>(sources.size(), nugget)), targets, chirality);
}

struct Sample {
  std::vector<Vec3> X = points_in_cube(9, 1), Y = points_in_cube(9, 2);
};

// The printed system [K P; P' 0] [W; t; A] = [V; 0], solved independently.
struct Dense {
  MatrixXd K, W, V, inverse_block;
  explicit Dense(const Sample& s) : K(kernel_matrix(s.X, 3)), V(rows_of(s.Y)) {
    const int n = static_cast<int>(s.X.size());
    MatrixXd L = MatrixXd::Zero(n + 4, n + 4), right = MatrixXd::Zero(n + 4, 3);
    L.topLeftCorner(n, n) = K;
    L.topRightCorner(n, 4) << Eigen::VectorXd::Ones(n), rows_of(s.X);
    L.bottomLeftCorner(4, n) = L.topRightCorner(n, 4).transpose();
    right.topRows(n) = V;
    W = L.colPivHouseholderQr().solve(right).topRows(n);
    inverse_block = L.inverse().topLeftCorner(n, n);
  }
};

TEST(Sec61, TheSplineMapsThePointsOntoTheirPartners) {
  const Sample s;
  const auto affine = ThinPlateSpline::affine_free(s.X, s.Y);
  const auto similar = similarity_free(s.X, s.Y), mirrored = similarity_free(s.X, s.Y, Chirality::mirrored);
  for (std::size_t i = 0; i < s.X.size(); ++i) {
    EXPECT_LT((affine(s.X[i]) - s.Y[i]).norm(), 1e-9);
    EXPECT_LT((similar(s.X[i]) - s.Y[i]).norm(), 1e-9);
    EXPECT_LT((mirrored(s.X[i]) - s.Y[i]).norm(), 1e-9);
  }
}

TEST(Sec61, WeightsAreThoseOfTheDenseSystem) {
  const Sample s;
  const Dense dense(s);
  const auto spline = ThinPlateSpline::affine_free(s.X, s.Y);
  EXPECT_LT((rows_of(spline.weights) - dense.W).norm(), 1e-7 * dense.W.norm());
}

TEST(Sec61, TotalCurvatureIsTraceOfWKWAndNotThePrintedWKV) {
  const Sample s;
  const Dense d(s);
  const double energy = ThinPlateSpline::affine_free(s.X, s.Y).energy;
  EXPECT_NEAR((d.V.transpose() * d.inverse_block * d.V).trace(), energy, 1e-8 * energy);  // trace[V' L_N^-1 V], as printed
  EXPECT_NEAR((d.W.transpose() * d.K * d.W).trace(), energy, 1e-8 * energy);
  EXPECT_NEAR((d.W.transpose() * d.V).trace(), energy, 1e-8 * energy);
  EXPECT_GT(std::abs((d.W.transpose() * d.K * d.V).trace() - energy), 0.1 * energy);  // printed as equal, but is not
}

TEST(Sec61, AffineMapsCostNothing) {
  const Sample s;
  Mat3 A;
  A << 1, 2, 0, -1, 3, 0.5, 0.2, 0, -2;
  const auto Y = mapped(s.X, [&](const Vec3& x) -> Vec3 { return A * x + Vec3(1, 2, 3); });
  const auto spline = ThinPlateSpline::affine_free(s.X, Y);
  EXPECT_NEAR(spline.energy, 0, 1e-9);
  EXPECT_LT((spline.affine.leftCols<3>() - A).norm(), 1e-9);
  EXPECT_GT(similarity_free(s.X, Y).energy, 0.1);  // the similarity-free form charges them
}

TEST(Sec61, SimilaritiesOfBothChiralitiesCostNothing) {
  const Sample s;
  for (const Chirality chirality : {Chirality::proper, Chirality::mirrored}) {
    const Similarity map = synthetic::similarity(chirality, 1.7);
    const auto spline = similarity_free(s.X, mapped(s.X, map), chirality);
    EXPECT_NEAR(spline.energy, 0, 1e-9);
    EXPECT_NEAR(spline.similarity.scale, 1.7, 1e-9);
    EXPECT_LT((spline.similarity.rotation - map.rotation).norm(), 1e-9);
    EXPECT_LT((spline.similarity.shift - map.shift).norm(), 1e-8);
    const Chirality other = chirality == Chirality::proper ? Chirality::mirrored : Chirality::proper;
    EXPECT_GT(similarity_free(s.X, mapped(s.X, map), other).energy, 0.1);
  }
}

TEST(Sec61, SimilarityFreeEnergyIsMinusTraceOfWKW) {
  const Sample s;
  const auto spline = similarity_free(s.X, s.Y);
  const MatrixXd W = rows_of(spline.weights);
  EXPECT_NEAR(-(W.transpose() * kernel_matrix(s.X, 1) * W).trace(), spline.energy, 1e-8 * spline.energy);
  EXPECT_LT(W.colwise().sum().norm(), 1e-9);
}

// E(B) = min over shifts of the energy of Y - X B', B = s R: the closed form must beat every similarity near it and far from it.
TEST(Sec61, NoOtherSimilarityIsCheaper) {
  const Sample s;
  const auto best = similarity_free(s.X, s.Y);
  const SourceSystem system(s.X, std::vector<double>(s.X.size(), 0));
  const auto energy_with = [&](const Mat3& B) {
    const Eigen::MatrixX3d residual = rows_of(s.Y) - rows_of(s.X) * B.transpose();
    return (residual.transpose() * system.solve(residual).topRows(residual.rows())).trace();
  };
  EXPECT_NEAR(energy_with(best.similarity.scale * best.similarity.rotation), best.energy, 1e-8 * best.energy);
  for (int k = 0; k < 60; ++k) {
    const Mat3 turn = Eigen::AngleAxisd(0.02 + 0.05 * k, Vec3(k % 3, k % 5, 1).normalized()).toRotationMatrix();
    EXPECT_GT(energy_with(best.similarity.scale * (1 + 0.01 * (k % 7)) * turn * best.similarity.rotation), best.energy);
  }
}

TEST(Sec61, EnergiesScaleByTargetSquaredOverSource) {
  const Sample s;
  const double r = similarity_free(s.X, s.Y).energy, r3 = ThinPlateSpline::affine_free(s.X, s.Y).energy;
  EXPECT_NEAR(similarity_free(scaled(s.X, 2), s.Y).energy, r / 2, 1e-8 * r);
  EXPECT_NEAR(similarity_free(s.X, scaled(s.Y, 3)).energy, r * 9, 1e-8 * r);
  EXPECT_NEAR(ThinPlateSpline::affine_free(scaled(s.X, 2), s.Y).energy, r3 / 8, 1e-8 * r3);
  EXPECT_NEAR(ThinPlateSpline::affine_free(s.X, scaled(s.Y, 3)).energy, r3 * 9, 1e-8 * r3);
}

TEST(Sec61, EnergyIgnoresMovingAndTurningEitherShape) {
  const Sample s;
  const Similarity move = synthetic::similarity(Chirality::proper, 1);
  for (const auto& [X, Y] : {std::pair{mapped(s.X, move), s.Y}, {s.X, mapped(s.Y, move)}}) {
    EXPECT_NEAR(similarity_free(X, Y).energy, similarity_free(s.X, s.Y).energy, 1e-8);
    const double affine = ThinPlateSpline::affine_free(s.X, s.Y).energy;
    EXPECT_NEAR(ThinPlateSpline::affine_free(X, Y).energy, affine, 1e-6 * affine);
  }
}

TEST(Sec61, FarFromTheOriginTheSplineIsTheSame) {
  const Sample s;
  const Vec3 far(3e8, -5e8, 1e9);  // doubles there are 1e-7 apart
  const auto away = [&](const Vec3& x) -> Vec3 { return x + far; };
  const ThinPlateSpline near = similarity_free(s.X, s.Y), there = similarity_free(mapped(s.X, away), mapped(s.Y, away));
  EXPECT_NEAR(there.similarity.scale, near.similarity.scale, 1e-5);
  EXPECT_NEAR(there.energy, near.energy, 1e-5);
  for (std::size_t i = 0; i < s.X.size(); ++i) EXPECT_LT((there(away(s.X[i])) - away(s.Y[i])).norm(), 1e-5);
  const ThinPlateSpline affine = ThinPlateSpline::affine_free(mapped(s.X, away), mapped(s.Y, away));
  for (std::size_t i = 0; i < s.X.size(); ++i) EXPECT_LT((affine(away(s.X[i])) - away(s.Y[i])).norm(), 1e-4);
}

TEST(Sec61, AffineFreeEnergyIsBlindToReflection) {
  const Sample s;
  const auto mirrored = mapped(s.Y, [](const Vec3& x) { return Vec3(-x.x(), x.y(), x.z()); });
  const double energy = ThinPlateSpline::affine_free(s.X, s.Y).energy;
  EXPECT_NEAR(ThinPlateSpline::affine_free(s.X, mirrored).energy, energy, 1e-8 * energy);
  EXPECT_NEAR(similarity_free(s.X, mirrored, Chirality::mirrored).energy, similarity_free(s.X, s.Y).energy, 1e-8);
  EXPECT_GT(std::abs(similarity_free(s.X, mirrored).energy - similarity_free(s.X, s.Y).energy), 0.01);
}

TEST(Sec61, SourcesInAPlaneHaveInfiniteAffineFreeEnergy) {
  auto flat = Sample().X;
  for (Vec3& x : flat) x.z() = 0.25;
  EXPECT_EQ(ThinPlateSpline::affine_free(flat, Sample().Y).energy, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isfinite(similarity_free(flat, Sample().Y).energy));
}

TEST(Sec61, NuggetsMakeApproximationsOfLessEnergy) {
  const Sample s;
  const auto misses = [&](const ThinPlateSpline& f) {
    double sum = 0;
    for (std::size_t i = 0; i < s.X.size(); ++i) sum += (f(s.X[i]) - s.Y[i]).squaredNorm();
    return sum;
  };
  double last_energy = similarity_free(s.X, s.Y).energy, last_miss = 0;
  for (const double nugget : {0.01, 0.1, 1.0}) {
    const auto spline = similarity_free(s.X, s.Y, Chirality::proper, nugget);
    EXPECT_LT(spline.energy, last_energy);
    EXPECT_GT(misses(spline), last_miss + 1e-6);
    last_energy = spline.energy;
    last_miss = misses(spline);
  }
}

TEST(Sec61, VarianceIsNoughtAtTheSourcesAndGrowsAway) {
  const Sample s;
  const SourceSystem system(s.X, std::vector<double>(s.X.size(), 0));
  EXPECT_NEAR(system.variance(s.X[3]), 0, 1e-9);
  const double near = system.variance(s.X[3] + Vec3(0.01, 0, 0)), far = system.variance(Vec3(5, 5, 5));
  EXPECT_GT(near, 0.001);
  EXPECT_GT(far, 1);
}

TEST(ThinPlateSpline, TooFewOrUnequalPointsAreRefused) {
  const auto three = points_in_cube(3, 1), four = points_in_cube(4, 1);
  EXPECT_THROW(ThinPlateSpline::affine_free(three, three), std::invalid_argument);
  EXPECT_THROW(ThinPlateSpline::affine_free(four, three), std::invalid_argument);
  EXPECT_THROW(SourceSystem({Vec3::Zero()}, {0}), std::invalid_argument);
  EXPECT_THROW(similarity_free(four, three), std::invalid_argument);
}

}  // namespace
}  // namespace homolog
