// SPDX-License-Identifier: MIT
#include "homolog/shape/label_surface.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "homolog/base/errors.h"
#include "homolog/shape/surface_nets.h"
#include "homolog/shape/thin_cells.h"
#include "homolog/shape/voxel_faces.h"

namespace homolog {
namespace {

constexpr int rounds = 20;                 // of smoothing: more change nothing that is found later
constexpr std::size_t most_labels = 1000;  // beyond, the values are those of a scan
constexpr std::size_t shown_labels = 12;
constexpr std::uint64_t most_of_noise = 700'000;  // triangles, which take 8 s of processor time at 224 voxels
constexpr double border_share = 0.95;             // of the border's voxels, which a shape that is cropped closely does not reach

/// A scale in a header, kept as a float, leaves a label beside the whole number that it was.
double whole(double value) {
  const double nearest = std::round(value);
  return std::abs(value - nearest) <= 1e-6 * std::abs(nearest) ? nearest : value;
}

std::set<long long> labels_of(const RawVolume& volume, const std::string& file) {
  std::set<long long> labels;
  double last = 0;
  for (std::size_t i = 0; i < volume.voxels(); ++i) {
    const double value = whole(volume.value(i));
    if (value == last) continue;
    last = value;
    if (!std::isfinite(value) || value != std::floor(value)) {
      throw FileError(fmt::format("{}: voxel {} holds {}, but labels are whole numbers; segment the scan first", file, i, value));
    }
    if (std::abs(value) > static_cast<double>(largest_label)) {
      throw FileError(fmt::format("{}: voxel {} holds {}, but labels are read up to {}; number them anew, or segment the scan first", file,
                                  i, value, largest_label));
    }
    labels.insert(static_cast<long long>(value));
    if (labels.size() > most_labels) {
      throw FileError(fmt::format("{}: it holds more than {} different values, as scans do; segment it first", file, most_labels));
    }
  }
  labels.erase(0);
  return labels;
}

/// The label that is meant, 0 for all.
long long chosen(const std::set<long long>& labels, const Label& label, const std::string& file) {
  if (labels.empty()) throw FileError(fmt::format("{}: all voxels are 0, so there is no shape", file));
  if (!label && labels.size() == 1) return *labels.begin();
  if (label && (*label == 0 || labels.count(*label) > 0)) return *label;
  std::vector<long long> first(labels.begin(),
                               std::next(labels.begin(), static_cast<std::ptrdiff_t>(std::min(labels.size(), shown_labels))));
  const std::string list = fmt::format("{}{}", fmt::join(first, ", "), labels.size() > shown_labels ? ", ..." : "");
  if (label) throw FileError(fmt::format("{}: there is no label {}, but {}", file, *label, list));
  throw FileError(
      fmt::format("{}: it holds the labels {}; say which one is meant by its label (0 for all), or save that one alone", file, list));
}

/// Is this the background, or the shape with all around it? It fills the border of the volume, and more than it is a block.
bool is_background(const RawVolume& volume, const std::function<bool(std::size_t)>& inside) {
  const auto [nx, ny, nz] = volume.size;
  std::size_t border = 0, on_border = 0;
  for (std::int64_t z = 0; z < nz; ++z) {
    for (std::int64_t y = 0; y < ny; ++y) {
      const bool whole_row = y == 0 || z == 0 || y == ny - 1 || z == nz - 1;
      const std::int64_t step = whole_row || nx == 1 ? 1 : nx - 1;
      for (std::int64_t x = 0; x < nx; x += step, ++border) on_border += inside(static_cast<std::size_t>((z * ny + y) * nx + x));
    }
  }
  if (static_cast<double>(on_border) <= border_share * static_cast<double>(border)) return false;
  for (std::size_t i = 0; i < volume.voxels(); ++i) {
    if (!inside(i)) return true;
  }
  return false;
}

struct Crop {
  std::array<std::int64_t, 3> first, end;
};

template <class Inside>
Crop crop_to(const RawVolume& volume, const Inside& inside) {
  Crop crop{volume.size, {0, 0, 0}};
  const auto nx = static_cast<std::size_t>(volume.size[0]), ny = static_cast<std::size_t>(volume.size[1]);
  for (std::size_t i = 0; i < volume.voxels(); ++i) {
    if (!inside(i)) continue;
    const std::size_t place[3] = {i % nx, i / nx % ny, i / nx / ny};
    for (int axis = 0; axis < 3; ++axis) {
      crop.first[axis] = std::min(crop.first[axis], static_cast<std::int64_t>(place[axis]));
      crop.end[axis] = std::max(crop.end[axis], static_cast<std::int64_t>(place[axis]) + 1);
    }
  }
  return crop;
}

template <class Inside>
SolidVoxels solid_in(const Crop& crop, const RawVolume& volume, const Inside& inside) {
  SolidVoxels solid;
  for (int axis = 0; axis < 3; ++axis) solid.size[axis] = static_cast<int>(crop.end[axis] - crop.first[axis]);
  for (std::int64_t z = crop.first[2]; z < crop.end[2]; ++z) {
    for (std::int64_t y = crop.first[1]; y < crop.end[1]; ++y) {
      const std::int64_t row = (z * volume.size[1] + y) * volume.size[0];
      for (std::int64_t x = crop.first[0]; x < crop.end[0]; ++x) solid.inside.push_back(inside(static_cast<std::size_t>(row + x)));
    }
  }
  return solid;
}

/// Before the surface is made, which takes seconds a million triangles, as does what follows.
void check_surface(const SolidVoxels& solid, std::size_t most_triangles, const std::string& file) {
  const VoxelFaces faces = voxel_faces(solid);
  if (faces.triangles() > most_triangles) {
    throw FileError(
        fmt::format("{}: the surface of its voxels has {} triangles, more than the {} that are read; crop or resample the volume", file,
                    faces.triangles(), most_triangles));
  }
  if (faces.triangles() > most_of_noise && are_scattered(solid, faces)) {
    throw FileError(fmt::format("{}: its voxels are scattered as noise is, with {} triangles around them; smooth the segmentation first",
                                file, faces.triangles()));
  }
}

}  // namespace

Mesh label_surface(const RawVolume& volume, const Label& label, const std::string& file, std::size_t most_triangles) {
  const auto wanted = static_cast<double>(chosen(labels_of(volume, file), label, file));
  const auto inside = [&](std::size_t i) { return wanted == 0 ? volume.value(i) != 0 : whole(volume.value(i)) == wanted; };
  if (!label && is_background(volume, inside)) {
    throw FileError(
        fmt::format("{}: the label {} fills the border of the volume, as a background does, and there is no other; save the "
                    "shape as a label of its own, or name this label",
                    file, wanted));
  }
  const Crop crop = crop_to(volume, inside);
  const SolidVoxels solid = solid_in(crop, volume, inside);
  check_surface(solid, most_triangles, file);
  const auto slice_size = static_cast<std::ptrdiff_t>(solid.size[0]) * solid.size[1];
  const SliceField field{solid.size, [&](int z, std::vector<float>& slice) {
                           const auto first_of_slice = solid.inside.begin() + z * slice_size;
                           std::copy(first_of_slice, first_of_slice + slice_size, slice.begin());
                         }};
  Mesh mesh = surface_nets(field, rounds, [&](const std::array<int, 3>& cell) { return is_thin(solid, cell); });
  const Vec3 first(static_cast<double>(crop.first[0]), static_cast<double>(crop.first[1]), static_cast<double>(crop.first[2]));
  const Mat3 axes = volume.world_from_voxel.topLeftCorner<3, 3>();
  const Vec3 origin = volume.world_from_voxel.topRightCorner<3, 1>();
  for (Vec3& vertex : mesh.vertices) vertex = axes * (vertex + first) + origin;
  if (axes.determinant() < 0) turn_over(mesh.triangles);
  return mesh;
}

}  // namespace homolog
