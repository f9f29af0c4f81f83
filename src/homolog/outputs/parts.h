// SPDX-License-Identifier: MIT
// What a user takes home of the parts that matches cover: `parts.json`, format "homolog-parts" version 1, and coloured meshes.
//
//   { "format": "homolog-parts", "version": 1, "program": "homolog x.y.z",
//     "model": { "file": "...", "vertices": n,
//                "box": [[x,y,z], [x,y,z]],                                     // of the part in use, least and greatest; not of a whole
//                "samples": [[x,y,z], ...] },                                   // even samples of the surface of the part in use
//     "data":  { the same },
//     "matches": [ { "model": { "vertices": [w, ...], "samples": [w, ...] },    // in the order of match.json
//                    "data":  { the same } } ] }
//
// A weight w is 0 outside the covered part and 1 inside (match/coverage.h says how), to three digits. Vertex i is the file's i-th; formats
// that store a vertex once per face (STL, glTF) count each place once, in the order of first occurrence.
#pragma once

#include "homolog/homolog.h"
#include "homolog/match/coverage.h"
#include "homolog/outputs/sink.h"

namespace homolog {

/// `parts` as covered_parts() made them.
void write_parts_json(const MeshedShape& model, const MeshedShape& data, const std::vector<MatchParts>& parts, const Sink& sink);

/// The mesh as PLY, grey with its covered part in teal; the weights, one a vertex, as property `quality`.
void write_part_ply(const Mesh& mesh, const std::vector<float>& weights, const Sink& sink);

}  // namespace homolog
