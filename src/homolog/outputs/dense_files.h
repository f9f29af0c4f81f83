// SPDX-License-Identifier: MIT
// What a user takes home of dense maps: tables, coloured meshes, and dense.json, format "homolog-dense" version 1, that sums them up:
//
//   { "format": "homolog-dense", "version": 1, "program": "homolog x.y.z", "match": n,              // 1 for the best
//     "data_from_model": { "from": "bear.off", "to": "bear_bis.off", "vertices": n, "placed": n,     // places of the model's vertices
//                          "torn_edges": n, "triangles": n, "folded_triangles": n },                 // match/dense.h
//     "model_from_data": { the same the other way } }
#pragma once

#include <string>
#include <vector>

#include "homolog/match/dense.h"
#include "homolog/outputs/ply.h"
#include "homolog/outputs/read_match.h"

namespace homolog {

/// vertex,triangle,b0,b1,b2,x,y,z,confidence: one row a vertex in its file's order, numbers from 0; x,y,z lie on the other mesh. Without a
/// place only the vertex is filled in, and confidence 0.
std::string dense_csv(const DenseMap& map);

/// A colour for every vertex: red, green and blue grow along x, y and z of the mesh's box.
std::vector<Colour> position_colours(const Mesh& mesh);

/// The colours of the other mesh at the places on it; grey without a place.
std::vector<Colour> carried_colours(const DenseMap& map, const Mesh& other, const std::vector<Colour>& colours);

/// The mesh with these colours and, as properties, place_x, place_y, place_z on the other mesh ("nan" without a place) and quality, the
/// confidence.
std::string dense_ply(const Mesh& mesh, const DenseMap& map, const std::vector<Colour>& colours);

/// `match`: its number in the family, 1 for the best.
std::string dense_json(const StoredFamily& family, int match, const DenseMaps& maps);

}  // namespace homolog
