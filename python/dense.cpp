// SPDX-License-Identifier: MIT
#include "dense.h"

#include <nanobind/eigen/dense.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <limits>

#include "arrays.h"
#include "homolog/base/errors.h"
#include "homolog/match/carry_attributes.h"
#include "homolog/outputs/attribute_files.h"
#include "homolog/outputs/attribute_transfer.h"
#include "homolog/outputs/morph.h"
#include "homolog/outputs/write_file.h"
#include "interruptible.h"

namespace nb = nanobind;

namespace homolog::python {
namespace {

using Numbers = Eigen::Matrix<std::int64_t, Eigen::Dynamic, 1>;
using Table = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

nb::dict map_fields(const DenseMap& map) {
  const auto or_none = [](const DensePlace& place, const Vec3& there) -> Vec3 { return place.is_there() ? there : Vec3::Constant(none); };
  nb::dict fields;
  fields["triangle"] = values_of(map.places, [](const DensePlace& p) { return p.is_there() ? std::int64_t{p.triangle} : -1; });
  fields["barycentric"] = places_of(map.places, [&](const DensePlace& p) { return or_none(p, p.barycentric); });
  fields["position"] = places_of(map.places, [&](const DensePlace& p) { return or_none(p, p.position); });
  fields["confidence"] = values_of(map.places, [](const DensePlace& p) { return p.confidence; });
  fields["torn"] = map.torn;
  fields["triangles"] = map.triangles;
  fields["folded"] = map.folded;
  return fields;
}

nb::dict morph_fields(const Morph& morph, const DenseMap& map) {
  nb::dict fields;
  fields["start"] = places_of(morph.start.vertices);
  fields["end"] = places_of(morph.end);
  fields["faces"] = triangles_of(morph.start);
  fields["triangles"] = map.triangles;
  fields["folded"] = map.folded;
  return fields;
}

nb::dict dense(const MatchMap& match, const Places& model_vertices, const Triangles& model_faces, const Places& data_vertices,
               const Triangles& data_faces) {
  DenseMaps maps;
  Morph morph;
  {
    Interruptible working;
    const Mesh model = mesh_of(model_vertices, model_faces), data = mesh_of(data_vertices, data_faces);
    maps = dense_maps(match, model, data);
    morph = make_morph(match, model, maps);
  }
  nb::dict fields;
  fields["data_from_model"] = map_fields(maps.data_from_model);
  fields["model_from_data"] = map_fields(maps.model_from_data);
  fields["morph"] = morph_fields(morph, maps.data_from_model);
  return fields;
}

/// The columns of `values`, of the vertices of the other mesh, at the places on it.
Table between(const Numbers& triangle, const Places& barycentric, const Triangles& faces, const Table& values, bool labels) {
  Interruptible working;
  Table result = Table::Constant(triangle.size(), values.cols(), none);
  for (Eigen::Index i = 0; i < triangle.size(); ++i) {
    if (triangle[i] < 0 || triangle[i] >= faces.rows()) continue;
    const Vec3 shares = barycentric.row(i).transpose();
    for (Eigen::Index column = 0; column < values.cols(); ++column) {
      std::array<double, 3> corners;
      for (int k = 0; k < 3; ++k) corners[static_cast<std::size_t>(k)] = values(faces(triangle[i], k), column);
      result(i, column) = labels ? label_between(corners, shares) : value_between(corners, shares);
    }
  }
  return result;
}

void write_morph(const std::filesystem::path& path, const Places& start, const Places& end, const Triangles& faces,
                 const std::vector<Colour>& colours) {
  Interruptible working;
  const Mesh first = mesh_of(start, faces), last = mesh_of(end, faces);
  write_file(path, morph_glb({first, last.vertices}, colours));
}

/// What `from` says of its mesh, carried to another one and written; returns how many vertices have a place, and what could not be
/// written, in sentences. `names`: of the shapes that were matched, and of the receiver. `read`: files that must not be overwritten.
nb::tuple transfer(const MatchMap& match, const std::filesystem::path& from, const std::filesystem::path& out, const Places& vertices,
                   const Triangles& faces, bool to_data, const std::vector<std::string>& labels, bool fill,
                   const std::array<std::string, 3>& names, const std::vector<std::filesystem::path>& read) {
  TransferredAttributes carried;
  {
    Interruptible working;
    if (!writes_attributes(out))
      throw ParamError(std::string("attributes are written as ") + writable_attributes + ", not as '" + out.string() + "'");
    const Direction direction = to_data ? Direction::data_from_model : Direction::model_from_data;
    const Mesh receiver = mesh_of(vertices, faces);
    carried = transfer_attributes({from, out, direction, labels, fill, {}, read}, match, {receiver, names[2]}, {names[0], names[1]});
  }
  return nb::make_tuple(carried.placed, carried.losses);
}

}  // namespace

void bind_dense(nb::module_& module, nb::class_<MatchMap>& map) {
  map.def("dense", &dense, nb::arg("model_vertices"), nb::arg("model_faces"), nb::arg("data_vertices"), nb::arg("data_faces"));
  map.def("transfer", &transfer, nb::arg("source"), nb::arg("out"), nb::arg("vertices"), nb::arg("faces"), nb::arg("to_data"),
          nb::arg("labels"), nb::arg("fill"), nb::arg("names"), nb::arg("read"));
  module.def("between", &between, nb::arg("triangle"), nb::arg("barycentric"), nb::arg("faces"), nb::arg("values"), nb::arg("labels"));
  module.def("write_morph", &write_morph, nb::arg("path"), nb::arg("start"), nb::arg("end"), nb::arg("faces"), nb::arg("colours"));
}

}  // namespace homolog::python
