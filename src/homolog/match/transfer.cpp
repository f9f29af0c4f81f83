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
constexpr double on_body = 0.1, off_body = 0.2;  // diagonals from the surface between which a point stops to belong to the shape
constexpr double most_doubt = 0.5;               // where no pair is near

/// Where the nearest image of a centre says that y comes from, were the map a similarity of this scale near it.
Vec3 first_guess(const ThinPlateSpline& f, const std::vector<Vec3>& images, double scale, const Vec3& y) {
  const Mat3 linear = f.affine.leftCols<3>();
  const auto nearer = [&](const Vec3& a, const Vec3& b) { return (a - y).squaredNorm() < (b - y).squaredNorm(); };
  const auto image = std::min_element(images.begin(), images.end(), nearer);
  if (image == images.end()) return linear.inverse() * (y - f.affine.col(3));
  return f.centres[static_cast<std::size_t>(image - images.begin())] + linear.transpose() * (y - *image) / (scale * scale);
}

}  // namespace

std::vector<MatchMap> match_maps(const std::vector<Match>& matches, const Shape& model, const Shape& data,
                                 const std::vector<MatchParts>& parts) {
  std::vector<MatchMap> maps;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    std::vector<KnownPlace> known;
    for (const Correspondence& c : matches[i].pairs) known.push_back({c.model_point.position, c.confidence});
    maps.push_back({matches[i].data_from_model,
                    std::move(known),
                    matches[i].similarity.scale,
                    matches[i].similarity.matrix(),
                    model.diagonal,
                    data.diagonal,
                    0,
                    matches[i].confidence,
                    {positions_of(model.surface), parts[i].model.samples, parts[i].model.box},
                    {positions_of(data.surface), parts[i].data.samples, parts[i].data.box}});
  }
  return maps;
}

Chirality chirality_of(const MatchMap& match) {
  return match.data_from_model.affine.leftCols<3>().determinant() < 0 ? Chirality::mirrored : Chirality::proper;
}

std::vector<Triangle> carried_triangles(const MatchMap& match, const Mesh& mesh) {
  std::vector<Triangle> triangles = mesh.triangles;
  if (chirality_of(match) == Chirality::mirrored) turn_over(triangles);
  return triangles;
}

double doubt_at(const std::vector<KnownPlace>& known, const Vec3& x, double extent) {
  double least = most_doubt;
  for (const KnownPlace& place : known) {
    const double distance = (x - place.position).norm() / extent + 0.02, against = (1.01 - place.confidence) / place.confidence;
    least = std::min(least, std::cbrt(distance * distance * against));
  }
  return least;
}

double expected_error_share(const Mat3& gradient, double doubt) {
  const Eigen::SelfAdjointEigenSolver<Mat3> squares(gradient.transpose() * gradient, Eigen::EigenvaluesOnly);
  const double largest = std::max(squares.eigenvalues()[2], std::numeric_limits<double>::min());
  const double smallest = std::max(squares.eigenvalues()[0], 1e-9 * largest);  // where the map is flat, too, an error is expected
  return 0.3 * std::sqrt(std::log(largest / smallest) / 2 + 0.05) * doubt;
}

double coverage_at(const CoveredSamples& samples, double diagonal, const Vec3& x) {
  if (samples.box && square_distance(*samples.box, x) > 0) return 0;
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
  if (!(total > 0)) return 0;  // so far away that squares are not finite
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
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double doubt = doubt_at(match.known, homes[i], extent / match.scale);
    carried[i].expected_error = (forwards ? extent : extent / match.scale) * expected_error_share(local[i].gradient, doubt);
    carried[i].position = forwards ? local[i].position : homes[i];
  }
  return carried;
}

}  // namespace homolog
