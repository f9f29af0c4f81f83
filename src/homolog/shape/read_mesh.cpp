// SPDX-License-Identifier: MIT
// Most formats by our own readers (their heads say why), the other scenes by assimp behind a fence (read_scene.h).
#include "homolog/shape/read_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "homolog/base/errors.h"
#include "homolog/base/read_file.h"
#include "homolog/shape/cloud_surface.h"
#include "homolog/shape/foreign_file.h"
#include "homolog/shape/outside_folder.h"
#include "homolog/shape/read_3mf.h"
#include "homolog/shape/read_gltf.h"
#include "homolog/shape/read_metaimage.h"
#include "homolog/shape/read_nifti.h"
#include "homolog/shape/read_nrrd.h"
#include "homolog/shape/read_obj.h"
#include "homolog/shape/read_off.h"
#include "homolog/shape/read_ply.h"
#include "homolog/shape/read_ply_cloud.h"
#include "homolog/shape/read_scene.h"
#include "homolog/shape/read_stl.h"
#include "homolog/shape/read_vtk.h"
#include "homolog/shape/read_vtp.h"
#include "homolog/shape/read_xyz.h"
#include "homolog/shape/text.h"
#include "homolog/shape/weld.h"

namespace homolog {
namespace {

namespace fs = std::filesystem;

/// Of formats that are known by what is in them.
constexpr std::array<std::string_view, 12> known_extensions{".ac",  ".dae", ".fbx",  ".3ds",  ".vtk", ".vtp",
                                                            ".xyz", ".nii", ".nrrd", ".nhdr", ".mha", ".mhd"};

void check_read(const Mesh& mesh, const std::string& file, std::size_t most_triangles) {
  if (mesh.triangles.empty())
    throw FileError(
        fmt::format("{}: the file holds no triangles; export the surface as a mesh, or its points with normals as PLY or .xyz", file));
  if (mesh.triangles.size() > most_triangles) {
    throw FileError(
        fmt::format("{}: {} triangles are more than the {} that are read; simplify the mesh", file, mesh.triangles.size(), most_triangles));
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (!mesh.vertices[i].allFinite()) {
      throw FileError(fmt::format("{}, vertex {}: a coordinate is not a finite number; the file is damaged", file, i));
    }
  }
}

std::optional<RawVolume> read_volume(std::string_view content, const fs::path& path, const ReadLimits& limits) {
  const ReadOther read_other = [&](const std::string& name) { return read_beside(path, name, limits.bytes); };
  if (is_nifti(content, path.string())) return read_nifti(content, path.string(), limits);
  if (is_nrrd(content)) return read_nrrd(content, path.string(), limits, read_other);
  if (is_metaimage(content)) return read_metaimage(content, path.string(), limits, read_other);
  return {};
}

Mesh surface_of(PointCloud cloud, const std::string& file, std::size_t most_points) {
  if (cloud.points.size() > most_points) {
    throw FileError(
        fmt::format("{}: {} points are more than the {} that are read; thin the cloud out", file, cloud.points.size(), most_points));
  }
  return cloud_surface(std::move(cloud), file);
}

Mesh read_ply_content(std::string_view content, const std::string& file, std::size_t most_points) {
  return is_ply_cloud(content, file) ? surface_of(read_ply_cloud(content, file), file, most_points) : read_ply(content, file);
}

Mesh read_content(const fs::path& path, std::string_view content, const ReadLimits& limits, const Tell& tell) {
  const std::string extension = lower_extension(path), file = path.string();
  const FindOther find_other = [&](const std::string& name) { return find_beside(path, name, limits.bytes); };
  if (const std::string format = scene_format(content, extension); !format.empty()) return read_scene(content, format, file, tell);
  if (content.starts_with("ply")) return read_ply_content(content, file, limits.triangles);
  if (is_vtk(content)) return read_vtk(content, file);
  if (is_vtp(content)) return read_vtp(content, file, limits.triangles);
  if (is_stl(content)) return read_stl(content, file);
  if (is_obj(content)) return read_obj(content, file, tell);
  if (is_gltf(content) || extension == ".gltf" || extension == ".glb") return weld(read_gltf(content, file, find_other, limits.triangles));
  if (is_3mf(content) || extension == ".3mf") return weld(read_3mf(content, file, limits, tell));
  if (extension == ".off" || is_off(content)) return read_off(content, file);
  if (extension == ".obj") return read_obj(content, file, tell);
  if (extension == ".ply") return read_ply(content, file);
  if (extension == ".stl") return read_stl(content, file);
  if (extension == ".xyz" || is_xyz(content)) return surface_of(read_xyz(content, file), file, limits.triangles);
  if (std::find(known_extensions.begin(), known_extensions.end(), extension) != known_extensions.end()) {
    throw FileError(
        fmt::format("{}: it does not begin as {} files do; it is damaged or of another format, export it again", file, extension));
  }
  throw FileError(
      fmt::format("{}: the format '{}' is not known; save a mesh as OFF, OBJ, PLY, STL, VTK, glTF, 3MF, AC3D, COLLADA, FBX or 3DS, a label "
                  "volume as .nii, .nii.gz, .nrrd or .mha, or a point cloud with normals as PLY or .xyz",
                  file, shown(extension)));
}

/// What 3D Slicer writes into the comments at the head of PLY, OBJ, STL and legacy VTK files.
bool states_ras(std::string_view content) { return content.substr(0, 1024).find("SPACE=RAS") != content.npos; }

}  // namespace

std::optional<std::string> find_beside(const fs::path& file, const std::string& name, std::uint64_t most) {
  std::error_code error;
  if (!fs::exists(file.parent_path() / name, error)) return {};
  return read_beside(file, name, most);
}

std::string read_beside(const fs::path& file, const std::string& name, std::uint64_t most) {
  const fs::path folder = fs::canonical(fs::absolute(file).parent_path());
  std::error_code error;
  const fs::path path = fs::weakly_canonical(folder / name, error);
  if (error || std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first != folder.end()) {
    throw OutsideFolder(
        fmt::format("{}: it names the file '{}' outside its folder; put the two together", file.string(), shown(name, 100)));
  }
  if (!fs::exists(path, error)) {
    throw FileError(fmt::format("{}: it names the file '{}', which is not there; put the two together", file.string(), shown(name)));
  }
  if (fs::is_directory(path, error)) {
    throw FileError(
        fmt::format("{}: it needs the file '{}', but that is a directory; put the file in its place", file.string(), shown(name)));
  }
  try {
    return read_file(path, most);
  } catch (const FileError& fault) {  // which names the file in full, but not the one that was named
    const std::string reason = std::string(fault.what()).substr(path.string().size() + 2);
    throw FileError(fmt::format("{}: it needs the file '{}', but {}", file.string(), shown(name), reason));
  }
}

Mesh read_mesh(const fs::path& path, const ReadLimits& limits, const Label& label, const Tell& tell) {
  const std::string content = read_file(path, limits.bytes);
  const std::optional<RawVolume> volume = read_volume(content, path, limits);
  if (label && !volume) throw FileError(fmt::format("{}: it holds no labels; leave the label out", path.string()));
  if (!volume && !is_3mf(content)) refuse_foreign(content, lower_extension(path), path.string());
  Mesh mesh = volume ? label_surface(*volume, label, path.string(), limits.triangles)
                     : read_content(path, without_byte_order_mark(content), limits, tell);
  if (!volume && states_ras(content)) mesh.ras = true;
  check_read(mesh, path.string(), limits.triangles);
  return mesh;
}

}  // namespace homolog
