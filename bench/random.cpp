// SPDX-License-Identifier: MIT
#include "random.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace homolog::bench {

Random::Random(std::uint64_t seed, const std::string& name) : state_(0xcbf29ce484222325ull) {
  for (const char c : name) state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  state_ ^= seed * 0x2545f4914f6cdd1dull;
}

double Random::unit() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

double Random::normal() {
  const double length = std::sqrt(-2 * std::log(1 - unit()));
  return length * std::cos(2 * std::numbers::pi * unit());
}

Vec3 Random::direction() { return rotation().col(0); }

// Shoemake's uniform unit quaternion.
Mat3 Random::rotation() {
  const double u = unit(), a = 2 * std::numbers::pi * unit(), b = 2 * std::numbers::pi * unit();
  const double p = std::sqrt(1 - u), q = std::sqrt(u);
  return Eigen::Quaterniond(q * std::cos(b), p * std::sin(a), p * std::cos(a), q * std::sin(b)).toRotationMatrix();
}

}  // namespace homolog::bench
