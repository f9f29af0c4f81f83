// SPDX-License-Identifier: MIT
// Reading shapes: meshes (most by ourselves, strictly, as their readers say; some scenes by assimp behind a fence), and the surfaces of
// labels in volumes and of point clouds.
#pragma once

#include <filesystem>
#include <optional>

#include "homolog/shape/label_surface.h"
#include "homolog/shape/mesh.h"
#include "homolog/shape/read_limits.h"
#include "homolog/shape/tell.h"

namespace homolog {

/// Reads OFF, OBJ, PLY, STL, VTK (legacy, .vtp, .vtu), glTF/GLB, 3MF, AC3D, COLLADA, FBX and 3DS. The vertices of OFF, OBJ, PLY and VTK
/// keep the file's order and numbers; those of the others are welded where they are exactly equal. Transforms of nodes are applied,
/// polygons become triangles, points and lines are left out. Of label volumes (NIfTI, NRRD, MetaImage) the surface of a label, in LPS; of
/// point clouds with normals (PLY without faces, XYZ) the surface that they were taken from (cloud_surface.h). All are known by how they
/// begin, scenes and 3MF by their names, too; what else a file is, is told (foreign_file.h). Throws FileError (missing, empty, truncated,
/// malformed, non-finite, beyond the limits, a label that is not there, points without normals).
/// `tell` is called with what the file holds and is left out, or is read although it is hidden.
Mesh read_mesh(const std::filesystem::path& path, const ReadLimits& limits = {}, const Label& label = {}, const Tell& tell = {});

/// Reads a file that another one names: in that one's folder or below, links followed. Throws FileError.
std::string read_beside(const std::filesystem::path& file, const std::string& name, std::uint64_t most = most_bytes);

/// The same, or none if it is not there.
std::optional<std::string> find_beside(const std::filesystem::path& file, const std::string& name, std::uint64_t most = most_bytes);

}  // namespace homolog
