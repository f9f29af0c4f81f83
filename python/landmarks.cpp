// SPDX-License-Identifier: MIT
#include "landmarks.h"

#include <nanobind/eigen/dense.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <limits>

#include "arrays.h"
#include "homolog/outputs/read_points.h"
#include "homolog/outputs/write_file.h"
#include "homolog/outputs/write_points.h"
#include "interruptible.h"

namespace nb = nanobind;

namespace homolog::python {
namespace {

using Labels = std::vector<std::string>;
using Numbers = Eigen::VectorXd;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

nb::tuple read(const std::filesystem::path& path, const std::string& specimen, bool ras) {
  std::vector<MarkupPoint> points;
  {
    Interruptible working;
    points = read_points(path, specimen, ras);
  }
  Labels labels;
  for (const MarkupPoint& point : points) labels.push_back(point.label);
  return nb::make_tuple(labels,
                        places_of(points, [](const MarkupPoint& p) -> Vec3 { return p.position.value_or(Vec3::Constant(missing)); }));
}

void write(const std::filesystem::path& path, const Labels& labels, const Places& places, const std::string& specimen, bool ras) {
  Interruptible working;
  std::vector<MarkupPoint> points;
  for (const Vec3& place : vectors_of(places)) {
    points.push_back({labels.at(points.size()), "", place.allFinite() ? std::optional(place) : std::nullopt});
  }
  write_file(path, points_text(points, path, specimen, ras));
}

void write_carried(const std::filesystem::path& path, const Labels& labels, const Places& places, const std::vector<bool>& there,
                   const Numbers& expected_error, const Numbers& coverage, const std::string& specimen, bool ras) {
  Interruptible working;
  std::vector<CarriedLandmark> landmarks;
  for (const Vec3& place : vectors_of(places)) {
    const std::size_t i = landmarks.size();
    const auto row = static_cast<Eigen::Index>(i);
    const CarriedPoint point{place, there.at(i), expected_error(row), coverage(row)};
    landmarks.push_back({labels.at(i), place.allFinite() ? std::optional(point) : std::nullopt});
  }
  write_file(path, points_text(landmarks, path, specimen, ras));
}

}  // namespace

void bind_landmarks(nb::module_& module) {
  module.def("read_landmarks", &read, nb::arg("path"), nb::arg("specimen"), nb::arg("ras"));
  module.def("write_landmarks", &write, nb::arg("path"), nb::arg("labels"), nb::arg("places"), nb::arg("specimen"), nb::arg("ras"));
  module.def("write_carried", &write_carried, nb::arg("path"), nb::arg("labels"), nb::arg("places"), nb::arg("there"),
             nb::arg("expected_error"), nb::arg("coverage"), nb::arg("specimen"), nb::arg("ras"));
}

}  // namespace homolog::python
