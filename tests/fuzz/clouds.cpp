// SPDX-License-Identifier: MIT
#include <array>
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

constexpr std::size_t bytes_a_point = 6 * sizeof(float), most_points = 12;
constexpr int least_voxels = 10;  // of the grid: one of the usual size takes the time of hundreds of files

std::string octahedron(float size) {
  std::string bytes;
  for (int i = 0; i < 6; ++i) {
    std::array<float, 6> point{};
    point[i / 2] = i % 2 ? -size : size;
    point[3 + i / 2] = i % 2 ? -1 : 1;
    bytes.append(reinterpret_cast<const char*>(point.data()), sizeof point);
  }
  return bytes;
}

/// Whatever finite numbers the bytes make.
PointCloud cloud_of(const std::string& bytes) {
  PointCloud cloud;
  for (std::size_t at = 0; at + bytes_a_point <= bytes.size() && cloud.points.size() < most_points; at += bytes_a_point) {
    std::array<float, 6> numbers{};
    std::memcpy(numbers.data(), bytes.data() + at, bytes_a_point);
    const Vec3 point(numbers[0], numbers[1], numbers[2]), normal(numbers[3], numbers[4], numbers[5]);
    if (!point.allFinite() || !normal.allFinite() || normal.isZero(0)) continue;
    cloud.points.push_back(point);
    cloud.normals.push_back(normal);
  }
  return cloud;
}

}  // namespace

/// The surface of a cloud.
Target cloud_surface() {
  return {"cloud_surface",
          {octahedron(1), octahedron(3).substr(0, 72) + octahedron(1e30f).substr(72)},
          [](const std::string& bytes) {
            const PointCloud cloud = cloud_of(bytes);
            if (cloud.points.empty()) return;
            run_mesh_reader([&](const std::string&, const std::string& file) { return homolog::cloud_surface(cloud, file, least_voxels); },
                            bytes);
          },
          2000};
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
