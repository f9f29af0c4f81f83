// SPDX-License-Identifier: MIT
#include "homolog/shape/ply_values.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

#include "homolog/base/errors.h"

namespace homolog {

PlySource open_ply(std::string_view content, const std::string& file) {
  PlySource source{{file, content}, {}, {}, {}};
  source.header = read_ply_header(source.text);
  return source;
}

void fail_at(const PlySource& source, const std::string& what) {
  if (source.header.encoding == PlyEncoding::ascii) fail(source.text, what);
  throw FileError(fmt::format("{}, {}: {}", source.text.file, source.place, what));
}

double read_ply_value(PlySource& source, NumberType type) {
  if (source.header.encoding == PlyEncoding::ascii) return take_number(source.text, source.line, "a property");
  const std::size_t size = bytes_of(type);
  if (source.text.rest.size() < size) fail_at(source, "the file ends here; it is truncated");
  const double value = stored_number(source.text.rest.data(), type,
                                     source.header.encoding == PlyEncoding::little_endian ? std::endian::little : std::endian::big);
  source.text.rest.remove_prefix(size);
  return value;
}

double read_loose_value(PlySource& source, NumberType type) {
  if (source.header.encoding != PlyEncoding::ascii) return read_ply_value(source, type);
  const std::string_view word = take_word(source.line);
  if (word.empty()) fail(source.text, "a property is missing; the file is truncated or damaged");
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() ? value : std::numeric_limits<double>::quiet_NaN();
}

std::size_t read_length(PlySource& source, const PlyProperty& property) {
  const double length = read_ply_value(source, property.count_type);
  const bool ascii = source.header.encoding == PlyEncoding::ascii;
  const std::size_t most = ascii ? source.line.size() / 2 : source.text.rest.size() / bytes_of(property.type);
  if (!(length >= 0 && length <= static_cast<double>(most)) || length != std::floor(length)) {
    fail_at(source, fmt::format("a list of {} items does not fit into the file; it is truncated or damaged", length));
  }
  return static_cast<std::size_t>(length);
}

void begin_element(PlySource& source, const PlyElement& element, std::size_t number) {
  if (source.header.encoding == PlyEncoding::ascii) {
    if (!next_data_line(source.text, source.line)) {
      fail(source.text, fmt::format("the file ends after {} of {} times element {}; it is truncated, or not each has a line of its own",
                                    number, element.count, shown(element.name)));
    }
  } else {
    source.place = fmt::format("{} {}", shown(element.name), number);
  }
}

void skip_property(PlySource& source, const PlyProperty& property) {
  const std::size_t length = property.count_type == NumberType::none ? 1 : read_length(source, property);
  for (std::size_t i = 0; i < length; ++i) {
    if (source.header.encoding != PlyEncoding::ascii) {
      read_ply_value(source, property.type);
    } else if (take_word(source.line).empty()) {
      fail(source.text, "a property is missing; the file is truncated or damaged");
    }
  }
}

void skip_elements(PlySource& source, const PlyElement& element) {
  for (std::size_t i = 0; i < element.count; ++i) {
    begin_element(source, element, i);
    for (const PlyProperty& property : element.properties) skip_property(source, property);
  }
}

}  // namespace homolog
