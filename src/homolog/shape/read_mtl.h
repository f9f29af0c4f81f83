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
};

struct MtlFile {
  std::vector<MtlMaterial> materials;
  std::vector<std::string> other_maps;  ///< keywords of other pictures than map_Kd, as "map_Bump", each once
};

/// newmtl, Kd, d and map_Kd; everything else is left out. Throws FileError, naming the line.
MtlFile read_mtl(std::string_view content, const std::string& file);

}  // namespace homolog
