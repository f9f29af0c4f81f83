// SPDX-License-Identifier: MIT
// The values of a PLY file, one after the other, whatever their encoding; every count is checked against the bytes that are there.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/ply_header.h"

namespace homolog {

/// Where the reader is: in ascii, `line` is what is left of the present element's line.
struct PlySource {
  Text text;
  PlyHeader header;
  std::string_view line;
  std::string place;  ///< of the present element, for messages of the binary encodings, which have no lines
};

/// At the first element, with the header read. Throws FileError as read_ply_header does.
PlySource open_ply(std::string_view content, const std::string& file);

/// Throws FileError, naming the line or the element.
[[noreturn]] void fail_at(const PlySource& source, const std::string& what);

/// To be called before the values of each element. Throws FileError at the end of the file.
void begin_element(PlySource& source, const PlyElement& element, std::size_t number);

/// The next value; a double holds every type exactly. Throws FileError, in ascii also for what is not finite.
double read_ply_value(PlySource& source, NumberType type);

/// The same, but NaN in ascii for what is no finite number: not every property need be one.
double read_loose_value(PlySource& source, NumberType type);

/// The length of a list, which fits into the rest of the file. Throws FileError.
std::size_t read_length(PlySource& source, const PlyProperty& property);

/// Passes over a property that nobody asked for; its values may be anything, such as the NaN of a normal without direction.
void skip_property(PlySource& source, const PlyProperty& property);

/// Passes over all elements of a kind.
void skip_elements(PlySource& source, const PlyElement& element);

}  // namespace homolog
