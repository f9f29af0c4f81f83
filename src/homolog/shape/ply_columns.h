// SPDX-License-Identifier: MIT
// The properties of a PLY's elements, each as a column.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "homolog/shape/ply_values.h"
#include "homolog/shape/texturing.h"

namespace homolog {

/// A property of all elements of a kind; NaN where there is no finite number.
struct PlyColumn {
  std::string name;
  NumberType type;
  std::vector<double> values;
  std::vector<std::size_t> ends = {};  ///< of a list: element i ends before values[ends[i]]; else empty

  /// The list of an element.
  std::span<const double> list(std::size_t element) const {
    const std::size_t first = element == 0 ? 0 : ends[element - 1];
    return {values.data() + first, ends[element] - first};
  }
};

/// Numbers of such a type are labels, others values.
inline bool is_whole(NumberType type) { return type < NumberType::float32; }

using PlyColumns = std::vector<PlyColumn>;

/// The single properties of all elements of a kind, and those lists that have one of these names. Throws FileError.
PlyColumns read_columns(PlySource& source, const PlyElement& element, const std::vector<std::string>& lists = {});

/// Takes the column of that name off; one without name if there is none.
PlyColumn take_column(PlyColumns& columns, const std::string& name);

/// Takes red, green, blue and perhaps alpha off, whole numbers as shares of their type's largest; nothing when the three are not all there.
std::vector<Rgba> take_colours(PlyColumns& columns);

}  // namespace homolog
