// SPDX-License-Identifier: MIT
// Sec. 4.1: the blur is linear, keeps mass, adds variances, and equals the plain triple sum.
#include "homolog/salient/gaussian_blur.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>

namespace homolog {
namespace {

Volume<float> empty_volume(int nx, int ny, int nz) {
  Volume<float> volume{{{nx, ny, nz}, Vec3::Zero(), 1}, {}};
  volume.values.assign(volume.frame.voxels(), 0);
  return volume;
}

Volume<float> noise(int nx, int ny, int nz) {
  Volume<float> volume = empty_volume(nx, ny, nz);
  std::mt19937 generator(5);
  for (int k = 3; k + 3 < nz; ++k) {
    for (int j = 2; j + 2 < ny; ++j) {
      for (int i = nx / 3; i < nx / 2; ++i) volume.at(i, j, k) = static_cast<float>(generator() % 1000) / 1000;
    }
  }
  return volume;
}

// A whole volume, `band` rows at a time.
Volume<float> gaussian_blur(const Volume<float>& volume, double sigma, int band = 1000) {
  const auto& [nx, ny, nz] = volume.frame.size;
  const GaussianBlur blur(sigma);
  RollingVolume in(volume.frame, nz, 1), out(volume.frame, nz, blur.plateau_after(1));
  const std::vector<std::uint8_t> mixed(in.blocks(), mixed_block);
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      std::copy(&volume.at(0, j, k), &volume.at(0, j, k) + nx, in.begin_row(j, k, mixed.data()));
      in.end_row(j, k);
    }
  }
  for (int k = 0; k < nz; k += row_group) {
    for (int j = 0; j < ny; j += band) blur.blur_rows(in, k, j, std::min(ny, j + band), out, [](int, int) {});
  }
  Volume<float> blurred = empty_volume(nx, ny, nz);
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) std::copy(out.row(j, k), out.row(j, k) + nx, &blurred.at(0, j, k));
  }
  return blurred;
}

double plain_blur_at(const Volume<float>& volume, const std::vector<float>& weights, int x, int y, int z) {
  const int radius = static_cast<int>(weights.size()) - 1;
  double sum = 0;
  for (int k = -radius; k <= radius; ++k) {
    for (int j = -radius; j <= radius; ++j) {
      for (int i = -radius; i <= radius; ++i) {
        if (!volume.frame.contains(x + i, y + j, z + k)) continue;
        sum += double(weights[std::abs(i)]) * weights[std::abs(j)] * weights[std::abs(k)] * volume.at(x + i, y + j, z + k);
      }
    }
  }
  return sum;
}

TEST(GaussianBlur, KernelHasUnitSumAndTheVarianceAskedFor) {
  for (const double sigma : {0.7, 1.22, 1.57, 3.09, 6.0}) {
    const std::vector<float> w = gaussian_kernel(sigma);
    double sum = w[0], variance = 0;
    for (std::size_t t = 1; t < w.size(); ++t) sum += 2 * w[t], variance += 2 * double(w[t]) * t * t;
    EXPECT_NEAR(sum, 1, 1e-6);
    EXPECT_NEAR(variance / (sigma * sigma), 1, 1e-5) << sigma;
  }
}

TEST(GaussianBlur, EqualsThePlainSumForAnyRowLength) {
  for (const int nx : {9, 31, 32, 33, 70}) {
    const Volume<float> volume = noise(nx, 12, 10), blurred = gaussian_blur(volume, 1.3);
    const std::vector<float> weights = gaussian_kernel(1.3);
    for (int k = 0; k < 10; k += 3) {
      for (int j = 0; j < 12; ++j) {
        for (int i = 0; i < nx; ++i) ASSERT_NEAR(blurred.at(i, j, k), plain_blur_at(volume, weights, i, j, k), 2e-6) << nx;
      }
    }
  }
}

TEST(GaussianBlur, VariancesAdd) {
  Volume<float> point = empty_volume(41, 41, 41);
  point.at(20, 20, 20) = 1;
  const Volume<float> twice = gaussian_blur(gaussian_blur(point, 1.5), 2), once = gaussian_blur(point, 2.5);
  EXPECT_NEAR(std::accumulate(twice.values.begin(), twice.values.end(), 0.0), 1, 1e-5);
  for (int i = 0; i < 41; ++i) EXPECT_NEAR(twice.at(i, 20, 20) / once.at(20, 20, 20), once.at(i, 20, 20) / once.at(20, 20, 20), 5e-3);
  // Sec. 4.1 corrected: the 3D Gaussian's top is (2 pi sigma^2)^(-3/2).
  EXPECT_NEAR(once.at(20, 20, 20) * std::pow(2 * M_PI * 6.25, 1.5), 1, 5e-3);
}

TEST(GaussianBlur, BytesDoNotDependOnBands) {
  const Volume<float> volume = noise(90, 50, 40);
  const std::vector<float> expected = gaussian_blur(volume, 2.1).values;
  for (const int band : {1, 8, 13, 24}) EXPECT_EQ(gaussian_blur(volume, 2.1, band).values, expected) << band;
}

TEST(GaussianBlur, InsideALargeBoxIsThePlateauThatIsForetold) {
  Volume<float> box = empty_volume(64, 40, 40);
  std::fill(box.values.begin(), box.values.end(), 1.0f);
  const GaussianBlur blur(1.5);
  const Volume<float> blurred = gaussian_blur(box, 1.5);
  EXPECT_EQ(blurred.at(32, 20, 20), blur.plateau_after(1));
  EXPECT_NEAR(blurred.at(32, 20, 20), 1, 1e-6);
  EXPECT_LT(blurred.at(0, 20, 20), 0.7);
}

}  // namespace
}  // namespace homolog
