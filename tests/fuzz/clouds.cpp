// SPDX-License-Identifier: MIT
#include "fuzz/target.h"
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

}  // namespace

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
