// SPDX-License-Identifier: MIT
// Where the triangles of a mesh lie on pictures.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace homolog {

using Rgba = std::array<float, 4>;  ///< red, green, blue, alpha, 0 to 1, as screens show them (sRGB)
using Uv = std::array<double, 2>;   ///< a place on a picture, mostly 0 to 1, from its lower left corner

struct Image {
  std::string name;   ///< of its file, without folders
  std::string bytes;  ///< of its file: PNG, JPEG, ...; empty: it was not there
};

struct Material {
  std::string name;
  Rgba colour = {0.8f, 0.8f, 0.8f, 1};
  int image = -1;  ///< in Texturing::images; -1: none
};

/// UVs belong to the corners of triangles, so that a vertex on a seam has several.
struct Texturing {
  static constexpr std::uint32_t no_uv = std::numeric_limits<std::uint32_t>::max();
  std::vector<Uv> uvs;
  std::vector<std::array<std::uint32_t, 3>> corners;  ///< of every triangle its three numbers in `uvs`, or three times no_uv
  std::vector<int> material_of;                       ///< every triangle's number in `materials`; -1: none
  std::vector<Material> materials;
  std::vector<Image> images;
  std::string gltf;  ///< "materials", "textures", "samplers" of a glTF file and "extensionsRequired", its JSON, which says more; else empty

  bool has_uvs(std::size_t triangle) const { return corners[triangle][0] != no_uv; }
};

}  // namespace homolog
