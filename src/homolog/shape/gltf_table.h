// SPDX-License-Identifier: MIT
// Tables of numbers in glTF files (accessors).
#pragma once

#include "homolog/shape/gltf_file.h"

namespace homolog {

struct GltfTable {
  std::size_t rows = 0, columns = 0;
  std::vector<double> values;  ///< row after row; finite

  double at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
  Vec3 vec3(std::size_t row) const { return {at(row, 0), at(row, 1), at(row, 2)}; }
};

/// What a table is asked to be: how many columns, and how many rows if that is known.
struct GltfTableForm {
  const char* what;  ///< for messages: "POSITION"
  std::vector<std::size_t> columns;
  std::optional<std::size_t> rows;
};

/// A table of any component type, normalised ones as shares, with its sparse part. Throws FileError for one of another form and where its
/// bytes are not there, before it takes memory for them.
GltfTable read_gltf_table(const GltfFile& file, std::size_t number, const GltfTableForm& form);

}  // namespace homolog
