// SPDX-License-Identifier: MIT
#include "homolog/match/transfer.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "homolog/base/parallel.h"
#include "homolog/match/local_map.h"

namespace homolog {
namespace {

constexpr std::size_t neighbours = 6;
constexpr std::size_t most_rivals = 3;
constexpr double on_body = 0.1, off_body = 0.2;  // diagonals from the surface between which a point stops to belong to the shape
constexpr double usual_disagreement = 0.042;     // extents; the median where there are other matches, for where there are none

/// Where the nearest image of a centre says that y comes from, were the map a similarity of this scale near it.
Vec3 first_guess(const ThinPlateSpline& f, const std::vector<Vec3>& images, double scale, const Vec3& y) {
  const Mat3 linear = f.affine.leftCols<3>();
  const auto nearer = [&](const Vec3& a, const Vec3& b) { return (a - y).squaredNorm() < (b - y).squaredNorm(); };
  const auto image = std::min_element(images.begin(), images.end(), nearer);
  if (image == images.end()) return linear.inverse() * (y - f.affine.col(3));
  return f.centres[static_cast<std::size_t>(image - images.begin())] + linear.transpose() * (y - *image) / (scale * scale);
}

/// Distances from the images of places to their nearest images by another match, in extents.
std::vector<double> disagreements(const MatchMap& match, const std::vector<Vec3>& places, const std::vector<LocalMap>& images,
                                  double extent) {
  std::vector<double> least(places.size(), match.rivals.empty() ? usual_disagreement : std::numeric_limits<double>::infinity());
  for (const ThinPlateSpline& rival : match.rivals) {
    const std::vector<LocalMap> others = local_maps(rival, places);
    for (std::size_t i = 0; i < places.size(); ++i) {
      least[i] = std::min(least[i], (others[i].position - images[i].position).norm() / extent);
    }
  }
  return least;
}

}  // namespace

std::vector<MatchMap> match_maps(const std::vector<Match>& matches, const Shape& model, const Shape& data,
                                 const std::vector<MatchParts>& parts) {
  std::vector<MatchMap> maps;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    maps.push_back({matches[i].data_from_model,
                    {},
                    matches[i].similarity.scale,
                    matches[i].similarity.matrix(),
                    model.diagonal,
                    data.diagonal,
                    {positions_of(model.surface), parts[i].model.samples},
                    {positions_of(data.surface), parts[i].data.samples}});
  }
  set_rivals(maps);
  return maps;
}

Chirality chirality_of(const MatchMap& match) {
  return match.data_from_model.affine.leftCols<3>().determinant() < 0 ? Chirality::mirrored : Chirality::proper;
}

void set_rivals(std::vector<MatchMap>& family) {
  for (std::size_t i = 0; i < family.size(); ++i) {
    for (std::size_t j = 0; j < family.size() && family[i].rivals.size() < most_rivals; ++j) {
      if (j != i) family[i].rivals.push_back(family[j].data_from_model);
    }
  }
}

double expected_error_share(const Mat3& gradient, double scale, double disagreement) {
  const Eigen::SelfAdjointEigenSolver<Mat3> squares(gradient.transpose() * gradient, Eigen::EigenvaluesOnly);
  double farthest = 0;
  for (int k = 0; k < 3; ++k) {
    const double stretch = std::sqrt(std::max(squares.eigenvalues()[k], 0.0)) / scale;
    farthest = std::max(farthest, std::abs(std::log(std::max(stretch, 1e-3))));
  }
  return 0.184 * std::sqrt((farthest + 0.02) * (disagreement + 0.01));
}

double coverage_at(const CoveredSamples& samples, double diagonal, const Vec3& x) {
  std::vector<std::pair<double, float>> nearest(std::min(neighbours, samples.positions.size()) + 1,
                                                {std::numeric_limits<double>::infinity(), 0.0f});
  for (std::size_t i = 0; i < samples.positions.size(); ++i) {
    const double square = (samples.positions[i] - x).squaredNorm();
    if (square >= nearest[nearest.size() - 2].first) continue;
    nearest.back() = {square, samples.weights[i]};
    for (std::size_t k = nearest.size() - 1; k > 0 && nearest[k].first < nearest[k - 1].first; --k) std::swap(nearest[k], nearest[k - 1]);
  }
  nearest.pop_back();
  const double tiny = 1e-18 * diagonal * diagonal;
  double sum = 0, total = 0;
  for (const auto& [square, weight] : nearest) {
    sum += weight / (square + tiny);
    total += 1 / (square + tiny);
  }
  return sum / total * fade(std::sqrt(nearest.front().first) / diagonal, on_body, off_body);
}

std::vector<Vec3> images_of_centres(const ThinPlateSpline& f) {
  std::vector<Vec3> images;
  for (const Vec3& centre : f.centres) images.push_back(f(centre));
  return images;
}

InversePlace inverse_at(const ThinPlateSpline& f, const std::vector<Vec3>& images, double scale, const Vec3& y) {
  constexpr int steps = 60, halvings = 12;
  Vec3 x = first_guess(f, images, scale, y);
  LocalMap local = local_map(f, x);
  const double enough = 1e-10 * (y.norm() + scale * x.norm());
  for (int step = 0; step < steps; ++step) {
    const Vec3 miss = y - local.position;
    if (miss.norm() <= enough) return {x, true};
    Vec3 way = local.gradient.fullPivLu().solve(miss);
    LocalMap next = local_map(f, x + way);
    for (int halved = 0; halved < halvings && !((y - next.position).norm() < miss.norm()); ++halved) {
      way /= 2;
      next = local_map(f, x + way);
    }
    if (!((y - next.position).norm() < miss.norm())) break;
    x += way;
    local = next;
  }
  return {x, false};
}

std::vector<CarriedPoint> carry_points(const MatchMap& match, const std::vector<Vec3>& points, Direction direction) {
  const bool forwards = direction == Direction::data_from_model;
  const CoveredSamples& samples = forwards ? match.model : match.data;
  const double diagonal = forwards ? match.model_diagonal : match.data_diagonal;
  const double extent = matched_extent(match.model_diagonal, match.scale, match.data_diagonal);
  const std::vector<Vec3> images = forwards ? std::vector<Vec3>{} : images_of_centres(match.data_from_model);
  std::vector<CarriedPoint> carried(points.size());
  std::vector<Vec3> homes = points;
  parallel_for(points.size(), [&](std::size_t i) {
    if (!samples.positions.empty()) carried[i].coverage = coverage_at(samples, diagonal, points[i]);
    if (forwards) return;
    const InversePlace home = inverse_at(match.data_from_model, images, match.scale, points[i]);
    homes[i] = home.position;
    carried[i].exact = home.exact;
  });
  const std::vector<LocalMap> local = local_maps(match.data_from_model, homes);
  const std::vector<double> disagreement = disagreements(match, homes, local, extent);
  for (std::size_t i = 0; i < points.size(); ++i) {
    carried[i].expected_error =
        (forwards ? extent : extent / match.scale) * expected_error_share(local[i].gradient, match.scale, disagreement[i]);
    carried[i].position = forwards ? local[i].position : homes[i];
  }
  return carried;
}

}  // namespace homolog
