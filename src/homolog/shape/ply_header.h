// SPDX-License-Identifier: MIT
// The header of a PLY file: which elements follow, and how their properties are stored.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "homolog/shape/text.h"

namespace homolog {

enum class PlyEncoding { ascii, little_endian, big_endian };
enum class PlyType { none, int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
  std::string name;
  PlyType type;        ///< of the value, or of a list's items
  PlyType count_type;  ///< of a list's length; none for a single value
};

struct PlyElement {
  std::string name;
  std::size_t count;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding;
  std::vector<PlyElement> elements;
};

/// Bytes of a value in the binary encodings; 0 for none.
std::size_t bytes_of(PlyType type);

/// Reads up to and including the line end_header. Throws FileError for anything the format does not allow, and for more elements than
/// the file has bytes for.
PlyHeader read_ply_header(Text& text);

}  // namespace homolog
