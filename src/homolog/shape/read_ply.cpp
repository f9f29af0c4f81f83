// SPDX-License-Identifier: MIT
#include "homolog/shape/read_ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "homolog/base/errors.h"
#include "homolog/shape/ply_header.h"
#include "homolog/shape/polygon.h"

namespace homolog {
namespace {

/// Where the reader is: in ascii, `line` is what is left of the present element's line.
struct Source {
  Text text;
  PlyEncoding encoding;
  std::string_view line;
  std::string place;  // of the present element, for messages of the binary encodings, which have no lines
};

[[noreturn]] void fail_at(const Source& source, const std::string& what) {
  if (source.encoding == PlyEncoding::ascii) fail(source.text, what);
  throw FileError(fmt::format("{}, {}: {}", source.text.file, source.place, what));
}

template <class T>
double decode(const char* bytes, std::endian order) {
  char buffer[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) buffer[i] = bytes[order == std::endian::native ? i : sizeof(T) - 1 - i];
  T value;
  std::memcpy(&value, buffer, sizeof(T));
  return static_cast<double>(value);
}

double decode(PlyType type, const char* bytes, std::endian order) {
  switch (type) {
    case PlyType::int8:
      return decode<std::int8_t>(bytes, order);
    case PlyType::uint8:
      return decode<std::uint8_t>(bytes, order);
    case PlyType::int16:
      return decode<std::int16_t>(bytes, order);
    case PlyType::uint16:
      return decode<std::uint16_t>(bytes, order);
    case PlyType::int32:
      return decode<std::int32_t>(bytes, order);
    case PlyType::uint32:
      return decode<std::uint32_t>(bytes, order);
    case PlyType::float32:
      return decode<float>(bytes, order);
    default:
      return decode<double>(bytes, order);
  }
}

/// The next value; a double holds every type exactly.
double read_value(Source& source, PlyType type) {
  if (source.encoding == PlyEncoding::ascii) return take_number(source.text, source.line, "a property");
  const std::size_t size = bytes_of(type);
  if (source.text.rest.size() < size) fail_at(source, "the file ends here; it is truncated");
  const double value =
      decode(type, source.text.rest.data(), source.encoding == PlyEncoding::little_endian ? std::endian::little : std::endian::big);
  source.text.rest.remove_prefix(size);
  return value;
}

std::size_t read_length(Source& source, const PlyProperty& property) {
  const double length = read_value(source, property.count_type);
  const bool ascii = source.encoding == PlyEncoding::ascii;
  const std::size_t most = ascii ? source.line.size() / 2 : source.text.rest.size() / bytes_of(property.type);
  if (!(length >= 0 && length <= static_cast<double>(most)) || length != std::floor(length)) {
    fail_at(source, fmt::format("a list of {} items does not fit into the file; it is truncated or damaged", length));
  }
  return static_cast<std::size_t>(length);
}

void begin_element(Source& source, const PlyElement& element, std::size_t number) {
  if (source.encoding == PlyEncoding::ascii) {
    if (!next_data_line(source.text, source.line)) {
      fail(source.text,
           fmt::format("the file ends after {} of {} times element {}; it is truncated", number, element.count, shown(element.name)));
    }
  } else {
    source.place = fmt::format("{} {}", shown(element.name), number);
  }
}

/// Passes over a property that nobody asked for; its values may be anything, such as the NaN of a normal without direction.
void skip(Source& source, const PlyProperty& property) {
  const std::size_t length = property.count_type == PlyType::none ? 1 : read_length(source, property);
  for (std::size_t i = 0; i < length; ++i) {
    if (source.encoding != PlyEncoding::ascii) {
      read_value(source, property.type);
    } else if (take_word(source.line).empty()) {
      fail(source.text, "a property is missing; the file is truncated or damaged");
    }
  }
}

void read_vertices(Source& source, const PlyElement& element, Mesh& mesh) {
  std::vector<int> axes;
  for (const PlyProperty& property : element.properties) {
    const bool axis =
        property.count_type == PlyType::none && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z';
    axes.push_back(axis ? property.name[0] - 'x' : -1);
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (std::count(axes.begin(), axes.end(), axis) != 1) fail(source.text, "element vertex must have the properties x, y and z once each");
  }
  mesh.vertices.resize(element.count);
  for (std::size_t i = 0; i < element.count; ++i) {
    begin_element(source, element, i);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      if (axes[k] < 0) {
        skip(source, element.properties[k]);
      } else if (!std::isfinite(mesh.vertices[i][axes[k]] = read_value(source, element.properties[k].type))) {
        fail_at(source, "a coordinate is not a finite number; the file is damaged");
      }
    }
  }
}

void read_faces(Source& source, const PlyElement& element, Mesh& mesh) {
  for (std::size_t i = 0; i < element.count; ++i) {
    begin_element(source, element, i);
    for (const PlyProperty& property : element.properties) {
      if (property.count_type == PlyType::none || (property.name != "vertex_indices" && property.name != "vertex_index")) {
        skip(source, property);
        continue;
      }
      std::vector<std::uint32_t> corners(read_length(source, property));
      for (std::uint32_t& corner : corners) {
        const double index = read_value(source, property.type);
        if (!(index >= 0 && index < static_cast<double>(mesh.vertices.size())) || index != std::floor(index)) {
          fail_at(source, fmt::format("vertex {} does not exist (the file has {}, counted from 0); the file is damaged", index,
                                      mesh.vertices.size()));
        }
        corner = static_cast<std::uint32_t>(index);
      }
      append_polygon(mesh, std::move(corners));
    }
  }
}

}  // namespace

Mesh read_ply(std::string_view content, const std::string& file) {
  Source source{{file, content}, PlyEncoding::ascii, {}, {}};
  const PlyHeader header = read_ply_header(source.text);
  source.encoding = header.encoding;
  Mesh mesh;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      if (!mesh.vertices.empty()) fail(source.text, "element vertex is announced twice");
      read_vertices(source, element, mesh);
    } else if (element.name == "face") {
      read_faces(source, element, mesh);
    } else {
      for (std::size_t i = 0; i < element.count; ++i) {
        begin_element(source, element, i);
        for (const PlyProperty& property : element.properties) skip(source, property);
      }
    }
  }
  return mesh;
}

}  // namespace homolog
