// SPDX-License-Identifier: MIT
// MTL, the materials of OBJ files (Wavefront).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "homolog/shape/texturing.h"

namespace homolog {

/// A material, and the file of its picture as the MTL names it; empty if it has none.
struct MtlMaterial {
  Material material;
  std::string picture;
  bool has_colour = false;
};

struct MtlFile {
  std::vector<MtlMaterial> materials;
  std::vector<std::string> other_maps;   ///< keywords of other pictures than map_Kd, as "map_Bump", each once
  std::vector<std::string> map_options;  ///< of map_Kd, as "-s", that show pictures otherwise than the UVs say, each once
};

/// newmtl, Kd, d and map_Kd; everything else is left out. Kd is white where a picture has none beside it, or a black one. Throws FileError,
/// naming the line.
MtlFile read_mtl(std::string_view content, const std::string& file);

}  // namespace homolog
