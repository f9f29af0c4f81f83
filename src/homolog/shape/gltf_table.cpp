// SPDX-License-Identifier: MIT
#include "homolog/shape/gltf_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "homolog/shape/number_type.h"

namespace homolog {
namespace {

using nlohmann::json;

/// A kind of number as it lies in the file.
struct Component {
  NumberType type = NumberType::none;
  double most = 1;  ///< by which normalised ones are divided
};

Component component_of(const GltfFile& file, const json& object, const char* what) {
  switch (number_at(file, object, "componentType").value_or(0)) {
    case 5120:
      return {NumberType::int8, 127};
    case 5121:
      return {NumberType::uint8, 255};
    case 5122:
      return {NumberType::int16, 32767};
    case 5123:
      return {NumberType::uint16, 65535};
    case 5125:
      return {NumberType::uint32, 4294967295};
    case 5126:
      return {NumberType::float32};
  }
  fail(file, fmt::format("its {} has a component type that glTF does not know", what));
}

std::size_t columns_of(const GltfFile& file, const json& accessor, const GltfTableForm& form) {
  const std::string type = text_at(accessor, "type");
  constexpr std::pair<const char*, std::size_t> types[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
  for (const auto& [name, columns] : types) {
    if (type == name && std::find(form.columns.begin(), form.columns.end(), columns) != form.columns.end()) return columns;
  }
  fail(file, fmt::format("its {} is not of a type that it can be", form.what));
}

/// Rows of numbers that lie in a view.
struct Rows {
  std::string_view bytes;
  std::size_t stride;
  Component component;
  double divisor;

  double at(std::size_t row, std::size_t column) const {
    const double value =
        stored_number(bytes.data() + row * stride + column * bytes_of(component.type), component.type, std::endian::little) / divisor;
    return divisor == 1 ? value : std::max(value, -1.0);
  }
};

/// `holder` names the view and the offset in it.
Rows rows_in(const GltfFile& file, const json& holder, const Component& component, std::size_t columns, std::size_t rows,
             const char* what) {
  const std::size_t number = number_at(file, holder, "bufferView").value_or(std::numeric_limits<std::size_t>::max());
  const std::string_view view = buffer_view(file, number);
  const std::size_t offset = number_at(file, holder, "byteOffset").value_or(0), size = columns * bytes_of(component.type);
  const std::size_t stride = number_at(file, entry(file, "bufferViews", number), "byteStride").value_or(size);
  const bool fits = offset <= view.size() &&
                    (rows == 0 || (stride >= size && size <= view.size() - offset && rows - 1 <= (view.size() - offset - size) / stride));
  if (!fits) fail(file, fmt::format("its {} reaches beyond its view", what));
  return {view.substr(offset), stride, component, 1};
}

void read_sparse(const GltfFile& file, const json& sparse, const Component& component, double divisor, GltfTable& table, const char* what) {
  const std::size_t count = number_at(file, sparse, "count").value_or(0);
  const json none = json::object();
  const json &indices = sparse.contains("indices") ? sparse["indices"] : none,
             &values = sparse.contains("values") ? sparse["values"] : none;
  const Rows rows = rows_in(file, indices, component_of(file, indices, what), 1, count, what);
  Rows given = rows_in(file, values, component, table.columns, count, what);
  given.divisor = divisor;
  for (std::size_t i = 0; i < count; ++i) {
    const double row = rows.at(i, 0);
    if (!(row >= 0 && row < static_cast<double>(table.rows))) fail(file, fmt::format("its {} names a row that does not exist", what));
    for (std::size_t k = 0; k < table.columns; ++k) table.values[static_cast<std::size_t>(row) * table.columns + k] = given.at(i, k);
  }
}

}  // namespace

GltfTable read_gltf_table(const GltfFile& file, std::size_t number, const GltfTableForm& form) {
  const json& accessor = entry(file, "accessors", number);
  const Component component = component_of(file, accessor, form.what);
  GltfTable table{number_at(file, accessor, "count").value_or(0), columns_of(file, accessor, form), {}};
  if (form.rows && table.rows != *form.rows) {
    fail(file, fmt::format("its {} has {} entries where {} are needed", form.what, table.rows, *form.rows));
  }
  const bool has_view = accessor.contains("bufferView");
  if (!has_view && !form.rows) fail(file, fmt::format("its {} has no data", form.what));
  const auto normalized = accessor.find("normalized");
  const double divisor = normalized != accessor.end() && normalized->is_boolean() && normalized->get<bool>() ? component.most : 1;
  if (has_view) {
    Rows rows = rows_in(file, accessor, component, table.columns, table.rows, form.what);
    rows.divisor = divisor;
    table.values.reserve(table.rows * table.columns);
    for (std::size_t row = 0; row < table.rows; ++row) {
      for (std::size_t k = 0; k < table.columns; ++k) table.values.push_back(rows.at(row, k));
    }
  } else {
    table.values.assign(table.rows * table.columns, 0);
  }
  if (const auto sparse = accessor.find("sparse"); sparse != accessor.end()) {
    read_sparse(file, *sparse, component, divisor, table, form.what);
  }
  const bool finite = std::all_of(table.values.begin(), table.values.end(), [](double value) { return std::isfinite(value); });
  if (!finite) fail(file, fmt::format("its {} holds a number that is not finite", form.what));
  return table;
}

}  // namespace homolog
