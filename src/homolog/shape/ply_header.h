// SPDX-License-Identifier: MIT
// The header of a PLY file: which elements follow, and how their properties are stored.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "homolog/shape/number_type.h"
#include "homolog/shape/text.h"

namespace homolog {

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyProperty {
  std::string name;
  NumberType type;        ///< of the value, or of a list's items
  NumberType count_type;  ///< of a list's length; none for a single value
};

struct PlyElement {
  std::string name;
  std::size_t count;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding;
  std::vector<PlyElement> elements;
  std::vector<std::string> comments = {};
};

/// Reads up to and including the line end_header. Throws FileError for anything the format does not allow, and for more elements than
/// the file has bytes for.
PlyHeader read_ply_header(Text& text);

}  // namespace homolog
