// SPDX-License-Identifier: MIT
// What is fuzzed: every reader of ours, with the files that fuzzing starts from. libfuzzer.cpp runs one target for long, fuzz_test.cpp all
// of them for a moment. A target takes any bytes, lets the reader refuse them, and ends the process when a promise of the reader is broken.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "homolog/base/errors.h"
#include "homolog/shape/mesh.h"

namespace homolog::fuzz {

struct Target {
  const char* name;
  std::vector<std::string> seeds;  ///< small files, right ones and what fuzzing has found
  std::function<void(const std::string& bytes)> run;
  int changed_files = 20000;  ///< that the unit tests try
};

Target off();
Target obj();
Target stl();
Target ply();
Target vtk();
Target vtp();
Target xyz();
Target ply_cloud();
Target cloud_surface();
Target gltf();
Target threemf();
Target threemf_parts();
Target nifti();
Target nrrd();
Target metaimage();
Target match_json();
Target points_csv();
Target markups();
Target fcsv();
Target pts();
Target tps();
Target morphologika();
Target parameters();
Target part();

inline std::vector<Target> all_targets() {
  return {off(),           obj(),     stl(),     ply(),           vtk(),   vtp(),          xyz(),        ply_cloud(),
          cloud_surface(), gltf(),    threemf(), threemf_parts(), nifti(), nrrd(),         metaimage(),  match_json(),
          points_csv(),    markups(), fcsv(),    pts(),           tps(),   morphologika(), parameters(), part()};
}

inline void require(bool kept, const char* promise) {
  if (kept) return;
  std::fprintf(stderr, "broken: %s\n", promise);
  std::abort();
}

/// A refusal is one line, without what would move a terminal's cursor.
inline void require_one_line(const std::exception& refusal) {
  for (const char c : std::string_view(refusal.what()))
    require(static_cast<unsigned char>(c) >= ' ' && c != '\x7f', "a refusal is one line");
}

/// What a mesh reader promises of every file: a FileError, or triangles of existing, finite vertices.
template <class Read>
void run_mesh_reader(const Read& read, const std::string& bytes) {
  Mesh mesh;
  try {
    mesh = read(bytes, "fuzzed");
  } catch (const FileError& error) {
    return require_one_line(error);
  }
  for (const Vec3& vertex : mesh.vertices) require(vertex.allFinite(), "coordinates are finite");
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) require(corner < mesh.vertices.size(), "corners exist");
  }
}

}  // namespace homolog::fuzz
