// SPDX-License-Identifier: MIT
// Farthest-point order of points, in blocks of neighbours: a block that is nearer to its chosen points than the new one can be is left
// alone, which is soon true of nearly all.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace homolog {

struct FarthestPoint {
  std::size_t number;
  float squared_distance;  ///< to the nearest chosen point
};

class FarthestPoints {
 public:
  /// Coordinates and their squares must be exact in single precision (whole numbers below 2048, for example).
  explicit FarthestPoints(const std::vector<Eigen::Vector3f>& points);

  void choose(std::size_t point);

  /// The point farthest from all chosen ones, of equals the one with the lowest number; infinitely far before the first.
  FarthestPoint farthest() const;

 private:
  struct Block {
    std::size_t begin, end;
    Eigen::Vector3f low, high;
    float farthest;     ///< largest squared distance of its points to the chosen ones
    std::size_t point;  ///< whose it is
  };
  void find_farthest(Block& block) const;

  std::vector<Eigen::Vector3f> points_;  ///< block by block
  std::vector<float> distances_;
  std::vector<std::size_t> numbers_;  ///< as given, parallel to points_
  std::vector<std::size_t> places_;   ///< of the points as given in points_
  std::vector<Block> blocks_;
};

}  // namespace homolog
