// SPDX-License-Identifier: MIT
#include "homolog/shape/read_ply_cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "homolog/base/errors.h"
#include "homolog/shape/ply_values.h"

namespace homolog {
namespace {

constexpr std::array<std::string_view, 6> names{"x", "y", "z", "nx", "ny", "nz"};
constexpr std::string_view long_normal = "normal_";  // as some write nx, ny, nz
constexpr int other = -1;

int column_of(std::string name) {
  if (name.starts_with(long_normal)) name.replace(0, long_normal.size(), "n");
  const auto found = std::find(names.begin(), names.end(), name);
  return found != names.end() ? static_cast<int>(found - names.begin()) : other;
}

/// For every property which of the six it is, or `other`.
std::vector<int> columns_of(const PlySource& source, const PlyElement& element) {
  std::vector<int> columns;
  for (const PlyProperty& property : element.properties) {
    columns.push_back(property.count_type == NumberType::none ? column_of(property.name) : other);
  }
  for (int column = 0; column < 6; ++column) {
    const auto count = std::count(columns.begin(), columns.end(), column);
    if (count == 0) throw FileError(fmt::format("{}: the file holds no faces, and {}", source.text.file, without_normals));
    if (count > 1) fail(source.text, fmt::format("element vertex has the property {} more than once", names[column]));
  }
  return columns;
}

void read_points(PlySource& source, const PlyElement& element, PointCloud& cloud) {
  const std::vector<int> columns = columns_of(source, element);
  for (std::size_t i = 0; i < element.count; ++i) {
    begin_element(source, element, i);
    std::array<double, 6> values{};
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (columns[k] == other) {
        skip_property(source, element.properties[k]);
      } else {
        values[columns[k]] = read_loose_value(source, element.properties[k].type);
      }
    }
    const Vec3 point(values[0], values[1], values[2]), normal(values[3], values[4], values[5]);
    if (!point.allFinite()) fail_at(source, "a coordinate is not a finite number; the file is damaged");
    if (!normal.allFinite() || normal.isZero(0)) continue;
    cloud.points.push_back(point);
    cloud.normals.push_back(normal);
  }
}

}  // namespace

bool is_ply_cloud(std::string_view content, const std::string& file) {
  const PlyHeader header = open_ply(content, file).header;
  return std::none_of(header.elements.begin(), header.elements.end(), [](const PlyElement& element) {
    return (element.name == "face" || element.name == "tristrips") && element.count > 0;
  });
}

PointCloud read_ply_cloud(std::string_view content, const std::string& file) {
  PlySource source = open_ply(content, file);
  PointCloud cloud;
  for (const PlyElement& element : source.header.elements) {
    if (element.name == "vertex") {
      read_points(source, element, cloud);
      break;
    }
    skip_elements(source, element);
  }
  if (cloud.points.empty()) throw FileError(fmt::format("{}: the file holds no faces, and {}", file, without_normals));
  return cloud;
}

}  // namespace homolog
