// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstring>

#include "fuzz/target.h"
#include "homolog/shape/cloud_surface.h"
#include "homolog/shape/read_ply_cloud.h"
#include "homolog/shape/read_xyz.h"

namespace homolog::fuzz {
namespace {

/// What a reader of point clouds promises of every file: a FileError, or finite points with as many normals.
template <class Read>
void run_cloud_reader(const Read& read, const std::string& bytes) {
  PointCloud cloud;
  try {
    cloud = read(bytes, "fuzzed");
  } catch (const FileError& error) {
    return require_one_line(error);
  }
  require(!cloud.points.empty() && cloud.points.size() == cloud.normals.size(), "there are points, each with a normal");
  for (const Vec3& point : cloud.points) require(point.allFinite(), "coordinates are finite");
  for (const Vec3& normal : cloud.normals) require(normal.allFinite() && !normal.isZero(0), "normals have a direction");
}

constexpr std::size_t bytes_a_point = 6 * sizeof(float), most_points = 12, ball_points = 144;  // fewer than 100 tell no surface
constexpr int voxels = 12;  // of the grid: one of the usual size takes the time of a hundred files

std::string point_of(const std::array<float, 6>& point) { return {reinterpret_cast<const char*>(point.data()), sizeof point}; }

/// Points of the unit ball along a spiral, each a golden angle on.
PointCloud ball() {
  PointCloud cloud;
  for (std::size_t i = 0; i < ball_points; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / ball_points, angle = 2.399963 * static_cast<double>(i),
                 r = std::sqrt(1 - z * z);
    cloud.normals.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  cloud.points = cloud.normals;
  return cloud;
}

/// A ball, a few points of which are whatever finite numbers the bytes make.
PointCloud cloud_of(const std::string& bytes) {
  PointCloud cloud = ball();
  for (std::size_t k = 0; k < most_points && (k + 1) * bytes_a_point <= bytes.size(); ++k) {
    std::array<float, 6> numbers{};
    std::memcpy(numbers.data(), bytes.data() + k * bytes_a_point, bytes_a_point);
    const Vec3 point(numbers[0], numbers[1], numbers[2]), normal(numbers[3], numbers[4], numbers[5]);
    if (!point.allFinite() || !normal.allFinite() || normal.isZero(0)) continue;
    cloud.points[k * ball_points / most_points] = point;
    cloud.normals[k * ball_points / most_points] = normal;
  }
  return cloud;
}

Mesh surface_of(const std::string& bytes, const std::string& file) {
  Mesh mesh = homolog::cloud_surface(cloud_of(bytes), file, voxels);
  require(!mesh.triangles.empty(), "a surface has triangles");
  return mesh;
}

}  // namespace

/// The surface of a cloud.
Target cloud_surface() {
  return {"cloud_surface",
          {point_of({0.5f, 0, 0, -1, 0, 0}), point_of({0, 1e30f, 2, 0, 1e-30f, 1})},
          [](const std::string& bytes) {
            if (bytes.empty()) surface_of(bytes, "a ball");  // is never refused
            run_mesh_reader(surface_of, bytes);
          },
          200};
}

Target xyz() {
  return {"xyz",
          {"# x y z nx ny nz\n0 0 0 0 0 -1\n1 0 0 1 0 0\n+.5 1e-300 7 0.6 0 0.8\r\n", "1 2 3\n", "1 2 3 255 0 0\n",
           "1\t2\t3\t0\t0\t0\n4 5 6 0 1 0"},
          [](const std::string& bytes) {
            run_cloud_reader(read_xyz, bytes);
            is_xyz(bytes);
          }};
}

Target ply_cloud() {
  const std::string header =
      "element vertex 2\nproperty float x\nproperty double y\nproperty short z\nproperty char nx\nproperty float ny\nproperty int nz\n"
      "property list uchar int of\nend_header\n";
  return {"ply_cloud",
          {"ply\nformat ascii 1.0\n" + header + "0 0 0 1 0 0 0\n1 0 0 -1 nan 2 2 5 6\n",
           "ply\nformat binary_little_endian 1.0\n" + header + std::string(48, '\1'),
           "ply\nformat binary_big_endian 1.0\nelement face 0\nproperty list uchar int vertex_indices\n" + header + std::string(48, '\0')},
          [](const std::string& bytes) {
            run_cloud_reader(read_ply_cloud, bytes);
            run_cloud_reader(
                [](const std::string& content, const std::string& file) {
                  is_ply_cloud(content, file);
                  return PointCloud{{Vec3::Zero()}, {Vec3::UnitX()}};
                },
                bytes);
          }};
}

}  // namespace homolog::fuzz
