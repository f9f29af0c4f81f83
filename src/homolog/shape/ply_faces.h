// SPDX-License-Identifier: MIT
// What the faces of a PLY say beside their corners: where they lie on pictures, and values that go to the vertices.
#pragma once

#include "homolog/shape/attributes.h"
#include "homolog/shape/ply_columns.h"

namespace homolog {

/// The faces of a file, of which every triangle of the mesh is a piece.
struct PlyFaces {
  PlyColumn corners, uvs, pictures;         ///< lists of vertices and, without a name if there are none, of UVs; numbers of pictures
  PlyColumns others;                        ///< single properties
  std::vector<std::uint32_t> of_triangles;  ///< for every triangle of the mesh its face
};

/// Throws FileError. Faces that are not those of the mesh, because the file has several kinds of them, come back without any column.
PlyFaces read_ply_faces(PlySource& source, const PlyElement& element, const Mesh& mesh);

/// Lays the triangles of the mesh where the faces say, on `count` pictures, which are its materials.
Texturing lay_by_faces(const PlyFaces& faces, const Mesh& mesh, std::size_t count);

/// Gives the vertices of the mesh what the faces around them say: of colours and values the mean, of labels the most frequent one. What
/// vertices say themselves stays.
void give_to_vertices(PlyFaces& faces, AttributedMesh& mesh);

}  // namespace homolog
