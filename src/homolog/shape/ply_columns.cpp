// SPDX-License-Identifier: MIT
#include "homolog/shape/ply_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace homolog {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double largest(NumberType type) {
  switch (type) {
    case NumberType::uint8:
      return 255;
    case NumberType::uint16:
      return 65535;
    case NumberType::int8:
      return 127;
    case NumberType::int16:
      return 32767;
    case NumberType::int32:
      return 2147483647;
    case NumberType::uint32:
      return 4294967295;
    default:
      return 1;
  }
}

auto find_column(PlyColumns& columns, const std::string& name) {
  return std::find_if(columns.begin(), columns.end(), [&](const PlyColumn& column) { return column.name == name; });
}

}  // namespace

PlyColumns read_columns(PlySource& source, const PlyElement& element, const std::vector<std::string>& lists) {
  PlyColumns columns(element.properties.size());
  std::vector<bool> is_list, is_wanted;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const PlyProperty& property = element.properties[k];
    columns[k] = {property.name, property.type, {}};
    is_list.push_back(property.count_type != NumberType::none);
    is_wanted.push_back(!is_list[k] || std::find(lists.begin(), lists.end(), property.name) != lists.end());
  }
  for (std::size_t i = 0; i < element.count; ++i) {
    begin_element(source, element, i);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (!is_wanted[k]) {
        skip_property(source, element.properties[k]);
        continue;
      }
      const std::size_t length = is_list[k] ? read_length(source, element.properties[k]) : 1;
      for (std::size_t item = 0; item < length; ++item) {
        const double value = read_loose_value(source, columns[k].type);
        columns[k].values.push_back(std::isfinite(value) ? value : none);
      }
      if (is_list[k]) columns[k].ends.push_back(columns[k].values.size());
    }
  }
  std::erase_if(columns, [](const PlyColumn& column) { return column.values.empty(); });
  return columns;
}

PlyColumn take_column(PlyColumns& columns, const std::string& name) {
  const auto column = find_column(columns, name);
  if (column == columns.end()) return {};
  PlyColumn taken = std::move(*column);
  columns.erase(column);
  return taken;
}

std::vector<Rgba> take_colours(PlyColumns& columns) {
  static const std::string names[] = {"red", "green", "blue", "alpha"};
  std::vector<Rgba> colours;
  for (int channel = 0; channel < 4; ++channel) {
    const auto column = find_column(columns, names[channel]);
    if (column == columns.end() && channel < 3) return {};
    if (column == columns.end()) continue;
    colours.resize(column->values.size(), Rgba{0, 0, 0, 1});
    for (std::size_t i = 0; i < colours.size(); ++i) {
      const double share = column->values[i] / largest(column->type);
      colours[i][channel] = static_cast<float>(std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0);
    }
  }
  for (const std::string& name : names) take_column(columns, name);
  return colours;
}

}  // namespace homolog
