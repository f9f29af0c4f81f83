// SPDX-License-Identifier: MIT
#include "change_mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "random.h"

namespace homolog::bench {
namespace {

// The box of a mesh with its axes, the longest first. An odd order of axes does no harm: it is undone.
struct Frame {
  Vec3 middle;
  std::array<int, 3> axes{0, 1, 2};
  double length;
};

Frame frame_of(const Mesh& mesh) {
  const Box box = bounding_box(mesh);
  const Vec3 sides = box.max - box.min;
  Frame frame;
  frame.middle = (box.min + box.max) / 2;
  std::stable_sort(frame.axes.begin(), frame.axes.end(), [&](int a, int b) { return sides[a] > sides[b]; });
  frame.length = sides[frame.axes[0]];
  return frame;
}

// Moves every vertex, told as (along, across, across) from the middle in shares of the length.
Mesh moved(Mesh mesh, const std::function<Vec3(const Vec3&)>& move) {
  const Frame frame = frame_of(mesh);
  for (Vec3& v : mesh.vertices) {
    Vec3 own;
    for (int k = 0; k < 3; ++k) own[k] = (v - frame.middle)[frame.axes[static_cast<std::size_t>(k)]] / frame.length;
    own = move(own);
    for (int k = 0; k < 3; ++k) {
      const int axis = frame.axes[static_cast<std::size_t>(k)];
      v[axis] = frame.middle[axis] + frame.length * own[k];
    }
  }
  return mesh;
}

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

}  // namespace

Mesh bent(const Mesh& mesh, double degrees) {
  const double curvature = radians(degrees);
  return moved(mesh, [=](const Vec3& x) {
    const double radius = 1 / curvature - x.y();
    return Vec3(std::sin(curvature * x.x()) * radius, 1 / curvature - std::cos(curvature * x.x()) * radius, x.z());
  });
}

Mesh twisted(const Mesh& mesh, double degrees) {
  return moved(mesh, [=](const Vec3& x) {
    const double c = std::cos(radians(degrees) * x.x()), s = std::sin(radians(degrees) * x.x());
    return Vec3(x.x(), c * x.y() - s * x.z(), s * x.y() + c * x.z());
  });
}

Mesh lengthened(const Mesh& mesh, double from, double factor) {
  return moved(mesh, [=](const Vec3& x) { return Vec3(x.x() + (factor - 1) * std::max(0.0, x.x() - (from - 0.5)), x.y(), x.z()); });
}

Mesh fattened(const Mesh& mesh, double factor) {
  return moved(mesh, [=](const Vec3& x) {
    const double f = 1 + (factor - 1) * (x.x() + 0.5);
    return Vec3(x.x(), f * x.y(), f * x.z());
  });
}

Mesh mirrored(const Mesh& mesh) {
  Mesh image = moved(mesh, [](const Vec3& x) { return Vec3(x.x(), x.y(), -x.z()); });
  for (auto& t : image.triangles) std::swap(t[1], t[2]);
  return image;
}

Mesh noisy(const Mesh& mesh, double deviation, std::uint64_t seed) {
  Random random(seed, "noise");
  Mesh changed = mesh;
  const double size = deviation * bounding_box(mesh).diagonal();
  for (Vec3& v : changed.vertices) v += size * Vec3(random.normal(), random.normal(), random.normal());
  return changed;
}

Mesh clustered(const Mesh& mesh, int cells) {
  const Box box = bounding_box(mesh);
  const double cell = (box.max - box.min).maxCoeff() / cells;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  std::vector<std::uint32_t> cluster_of;
  std::vector<double> sizes;
  Mesh coarse;
  for (const Vec3& v : mesh.vertices) {
    const Eigen::Vector3i place = ((v - box.min) / cell).cast<int>();
    const auto [entry, is_new] = numbers.try_emplace({place.x(), place.y(), place.z()}, static_cast<std::uint32_t>(numbers.size()));
    if (is_new) coarse.vertices.push_back(Vec3::Zero()), sizes.push_back(0);
    coarse.vertices[entry->second] += v;
    ++sizes[entry->second];
    cluster_of.push_back(entry->second);
  }
  for (std::size_t i = 0; i < sizes.size(); ++i) coarse.vertices[i] /= sizes[i];
  for (const auto& [a, b, c] : mesh.triangles) {
    const Triangle t{cluster_of[a], cluster_of[b], cluster_of[c]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) coarse.triangles.push_back(t);
  }
  return coarse;
}

}  // namespace homolog::bench
