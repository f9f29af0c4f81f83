// SPDX-License-Identifier: MIT
#include "homolog/outputs/read_warp.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "homolog/base/errors.h"
#include "homolog/outputs/json_text.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

/// Space stays space, and is no plane, line or point.
bool is_map(const Mat3& linear) { return std::abs(linear.determinant()) > 1e-12 * std::pow(linear.norm(), 3); }

}  // namespace

void fail(const std::string& file, const std::string& what) { throw FileError(fmt::format("{}: {}", file, what)); }

std::size_t read_whole_number(const ordered_json& value, const std::string& file) {
  if (!value.is_number_unsigned()) fail(file, fmt::format("{} is not a whole number from 0 on; the file is damaged", shown_value(value)));
  return value.get<std::size_t>();
}

Vec3 read_vector(const ordered_json& item, const std::string& file) {
  const auto x = item.get<std::array<double, 3>>();
  if (item.size() != 3) fail(file, "a vector has not three numbers; the file is damaged");
  return {x[0], x[1], x[2]};
}

std::vector<Vec3> read_vectors(const ordered_json& list, const std::string& file) {
  std::vector<Vec3> vectors;
  for (const ordered_json& item : list) vectors.push_back(read_vector(item, file));
  return vectors;
}

Mat4 read_matrix(const ordered_json& rows) {
  Mat4 matrix;
  for (int row = 0; row < 4; ++row) {
    const auto values = rows.at(row).get<std::array<double, 4>>();
    matrix.row(row) = Eigen::RowVector4d(values[0], values[1], values[2], values[3]);
  }
  return matrix;
}

ThinPlateSpline read_warp(const ordered_json& json, const std::string& file) {
  ThinPlateSpline warp;
  const std::string kernel = json.at("kernel");
  if (kernel != "r" && kernel != "r3") fail(file, fmt::format("the kernel '{}' is not known; use a newer homolog", shown(kernel)));
  warp.kernel = kernel == "r" ? Kernel::r : Kernel::r3;
  warp.centres = read_vectors(json.at("centres"), file);
  warp.weights = read_vectors(json.at("weights"), file);
  if (warp.centres.size() != warp.weights.size()) fail(file, "a warp has not as many weights as centres; the file is damaged");
  for (int row = 0; row < 3; ++row) {
    const auto values = json.at("affine").at(row).get<std::array<double, 4>>();
    warp.affine.row(row) = Eigen::RowVector4d(values[0], values[1], values[2], values[3]);
  }
  if (!is_map(warp.affine.leftCols<3>())) fail(file, "a warp makes a plane, a line or a point of space; the file is damaged");
  return warp;
}

}  // namespace homolog
