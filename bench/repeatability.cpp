// SPDX-License-Identifier: MIT
// Sec. 4: how many salient points of a mesh are found again when it is turned at random. Voxels, and with them the grid's accidents,
// change with the turn; the shape does not.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "homolog/base/errors.h"
#include "homolog/base/parameters.h"
#include "homolog/salient/salient_points.h"
#include "homolog/shape/read_mesh.h"
#include "homolog/shape/voxelize.h"
#include "settings.h"

namespace homolog {
namespace {

// What counts as found again, in the smaller of the two radii and in log r.
constexpr double kPlace = 0.35, kScale = 0.3;

struct Tally {
  std::size_t points = 0, repeated = 0, fewest = SIZE_MAX, most = 0;
  std::vector<double> shifts;  // of repeated points, in radii

  void add(const Tally& other) {
    points += other.points;
    repeated += other.repeated;
    fewest = std::min(fewest, other.fewest);
    most = std::max(most, other.most);
    shifts.insert(shifts.end(), other.shifts.begin(), other.shifts.end());
  }
};

Mat3 random_rotation(std::mt19937& generator) {
  std::normal_distribution<double> normal;
  const double w = normal(generator), x = normal(generator), y = normal(generator), z = normal(generator);
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

// Salient points of the turned mesh, turned back.
std::vector<SalientPoint> points_of_turned(Mesh mesh, const Mat3& rotation, const Params& params) {
  for (Vec3& v : mesh.vertices) v = rotation * v;
  std::vector<SalientPoint> points = find_salient_points(voxelize(mesh, params.voxel.resolution).interior, params.salient);
  for (SalientPoint& p : points) p.position = rotation.transpose() * p.position;
  return points;
}

void count_repeated(const std::vector<SalientPoint>& points, const std::vector<SalientPoint>& others, Tally& tally) {
  for (const SalientPoint& p : points) {
    double nearest = kPlace;
    for (const SalientPoint& q : others) {
      if (std::abs(std::log(p.radius / q.radius)) > kScale) continue;
      nearest = std::min(nearest, (p.position - q.position).norm() / std::min(p.radius, q.radius));
    }
    ++tally.points;
    if (nearest >= kPlace) continue;
    ++tally.repeated;
    tally.shifts.push_back(nearest);
  }
}

Tally tally_mesh(const Mesh& mesh, int turns, const Params& params) {
  std::mt19937 generator(1);
  Tally tally;
  std::vector<SalientPoint> first;
  for (int turn = 0; turn <= turns; ++turn) {
    const std::vector<SalientPoint> points = points_of_turned(mesh, random_rotation(generator), params);
    tally.fewest = std::min(tally.fewest, points.size());
    tally.most = std::max(tally.most, points.size());
    if (turn == 0) {
      first = points;
      continue;
    }
    count_repeated(first, points, tally);
    count_repeated(points, first, tally);
  }
  return tally;
}

void print_row(const std::string& name, Tally tally) {
  std::sort(tally.shifts.begin(), tally.shifts.end());
  const auto quantile = [&](double q) {
    return tally.shifts.empty() ? 0 : tally.shifts[static_cast<std::size_t>(q * (tally.shifts.size() - 1))];
  };
  const double share = tally.points == 0 ? 0 : static_cast<double>(tally.repeated) / static_cast<double>(tally.points);
  fmt::print("{:32} {:4}..{:<4} {:8.3f} {:8.3f} {:8.3f}\n", name, tally.fewest, tally.most, share, quantile(0.5), quantile(0.9));
}

int run(int argc, char** argv) {
  CLI::App app{"Share of salient points found again in turned copies of meshes"};
  std::vector<std::string> files, settings;
  int turns = 3;
  app.add_option("files", files, "Meshes")->required();
  app.add_option("--turns", turns, "Turned copies of each mesh")->capture_default_str()->check(CLI::Range(1, 100));
  app.add_option("--param", settings, "NAME=VALUE, a parameter other than by default (repeatable)")->take_all();
  CLI11_PARSE(app, argc, argv);
  Params params;
  bench::set_parameters(params, settings);
  fmt::print("{:32} {:>10} {:>8} {:>8} {:>8}\n", "mesh", "points", "repeat", "shift/r", "p90");
  Tally all;
  for (const std::string& file : files) {
    const Tally tally = tally_mesh(read_mesh(file), turns, params);
    print_row(std::filesystem::path(file).stem().string(), tally);
    all.add(tally);
  }
  print_row("all", all);
  return 0;
}

}  // namespace
}  // namespace homolog

int main(int argc, char** argv) {
  try {
    return homolog::run(argc, argv);
  } catch (const homolog::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
