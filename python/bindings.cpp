// SPDX-License-Identifier: MIT
// The module homolog._core: the library's calls on numpy arrays. python/homolog makes them pythonic.
#include <nanobind/eigen/dense.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <map>
#include <tuple>
#include <vector>

#include "arrays.h"
#include "dense.h"
#include "found.h"
#include "homolog/shape/read_mesh.h"
#include "interruptible.h"
#include "landmarks.h"
#include "results.h"

namespace nb = nanobind;

namespace homolog::python {
namespace {

using Corners = Eigen::Matrix<double, 2, 3, Eigen::RowMajor>;
using Given = std::map<std::string, std::string>;  // parameters by name, as text

// A shape keeps what it was described with, so that a match under other parameters is noticed.
struct Described {
  Mesh mesh;
  Params params;
  Shape shape;

  MeshedShape meshed() const { return {mesh, shape}; }
};

int threads_of(const std::string& text) {
  constexpr int most = 1024;
  const bool number = !text.empty() && text.size() <= 4 && text.find_first_not_of("0123456789") == text.npos;
  if (!number || std::stoi(text) > most)
    throw ParamError("threads is '" + text + "', but must be a whole number from 0 (all cores) to " + std::to_string(most));
  return std::stoi(text);
}

Params params_of(const Given& given) {
  const auto named = given.find("preset");
  Params params = named == given.end() ? Params{} : preset(named->second);
  for (const auto& [name, value] : given) {
    if (name == "threads") params.threads = threads_of(value);
    if (name != "preset" && name != "threads") set_parameter(params, name, value);
  }
  return params;
}

// Only what describe_shape looks at.
Params describing(const Params& params) {
  Params only;
  only.voxel = params.voxel;
  only.salient = params.salient;
  only.descriptor = params.descriptor;
  return only;
}

void check_described_with(const Described& described, const Params& params) {
  for (const ParameterInfo& info : parameter_table()) {
    const auto had = get_parameter(describing(described.params), info.name), wanted = get_parameter(describing(params), info.name);
    if (had != wanted)
      throw ParamError("the shape '" + described.shape.name + "' was described with " + info.name + " " + to_text(had) +
                       ", but this call asks for " + to_text(wanted) + "; describe it again");
  }
}

/// The mesh, whether it is in RAS, and what was said while it was read.
std::tuple<Places, Triangles, bool, std::vector<std::string>> read(const std::filesystem::path& path, const Label& label,
                                                                   const std::map<std::string, std::uint64_t>& most) {
  ReadLimits limits;
  for (const auto& [what, number] : most) {
    if (what == "bytes") limits.bytes = number;
    if (what == "triangles") limits.triangles = number;
    if (what == "voxels") limits.voxels = number;
  }
  Mesh mesh;
  std::vector<std::string> told;
  {
    Interruptible working;
    mesh = read_mesh(path, limits, label, [&](const std::string& sentence) { told.push_back(sentence); });
  }
  return {places_of(mesh.vertices), triangles_of(mesh), mesh.ras, told};
}

Described describe(const Places& vertices, const Triangles& triangles, const std::string& name, bool ras,
                   const std::optional<Corners>& part, const Given& given) {
  Interruptible working;
  Described described;
  described.params = params_of(given);
  described.mesh = mesh_of(vertices, triangles);
  described.mesh.ras = ras;
  const auto box = part ? std::optional(Box{part->row(0), part->row(1)}) : std::nullopt;
  described.shape = describe_shape(described.mesh, described.params, box);
  described.shape.name = name;
  return described;
}

// What `find` finds of the model in the data.
template <class Find>
nb::tuple found(const Described& model, const Described& data, const Given& given, bool against_itself, Find find) {
  Params params;
  Family family;
  {
    Interruptible working;
    params = params_of(given);
    check_described_with(model, params);
    check_described_with(data, params);
    family = find(model.shape, data.shape, params);
  }
  return family_of(model.meshed(), data.meshed(), std::move(family), params, against_itself);
}

nb::tuple match(const Described& model, const Described& data, const Given& given) {
  return found(model, data, given, false, [](const Shape& a, const Shape& b, const Params& params) { return match_shapes(a, b, params); });
}

nb::tuple symmetry(const Described& shape, const Given& given) {
  return found(shape, shape, given, true, [](const Shape& a, const Shape&, const Params& params) { return find_symmetries(a, params); });
}

Places warp(const std::string& kernel, const Places& centres, const Places& weights, const Eigen::Matrix<double, 3, 4>& affine,
            const Places& places) {
  Interruptible working;
  ThinPlateSpline spline;
  spline.kernel = kernel == "r3" ? Kernel::r3 : Kernel::r;
  spline.centres = vectors_of(centres);
  spline.weights = vectors_of(weights);
  spline.affine = affine;
  std::vector<Vec3> mapped = vectors_of(places);
  parallel_for(mapped.size(), [&](std::size_t i) { mapped[i] = spline(mapped[i]); });
  return places_of(mapped);
}

nb::list parameters() {
  nb::list rows;
  for (const ParameterInfo& info : parameter_table()) {
    nb::dict row;
    row["name"] = info.name;
    row["sentence"] = info.sentence;
    row["unit"] = info.unit;
    row["default"] = std::visit([](const auto& value) { return nb::cast(value); }, get_parameter(Params{}, info.name));
    row["range"] = info.choices.empty() ? nb::cast(std::pair(info.min, info.max)) : nb::cast(info.choices);
    rows.append(row);
  }
  return rows;
}

void translate(const std::exception_ptr& thrown, void*) {
  try {
    std::rethrow_exception(thrown);
  } catch (const FileError& error) {
    PyErr_SetString(PyExc_OSError, error.what());
  } catch (const OutputError& error) {
    PyErr_SetString(PyExc_OSError, error.what());
  } catch (const Error& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  }
}

}  // namespace
}  // namespace homolog::python

NB_MODULE(_core, module) {
  namespace py = homolog::python;
  module.attr("__version__") = HOMOLOG_VERSION;
  nb::register_exception_translator(py::translate);
  nb::class_<py::Described>(module, "Described")
      .def_prop_ro("diagonal", [](const py::Described& d) { return d.shape.diagonal; })
      .def_prop_ro("guessed", [](const py::Described& d) { return d.shape.guessed; })
      .def_prop_ro("points", [](const py::Described& d) { return py::points_fields(d.shape.points); });
  auto match_map = py::bind_match_map(module);
  py::bind_dense(module, match_map);
  py::bind_found(module);
  py::bind_landmarks(module);
  module.def("read", &py::read, nb::arg("path"), nb::arg("label").none(), nb::arg("most"));
  module.def("describe", &py::describe, nb::arg("vertices"), nb::arg("triangles"), nb::arg("name"), nb::arg("ras"), nb::arg("part").none(),
             nb::arg("parameters"));
  module.def("match", &py::match, nb::arg("model"), nb::arg("data"), nb::arg("parameters"));
  module.def("symmetry", &py::symmetry, nb::arg("shape"), nb::arg("parameters"));
  module.def("warp", &py::warp, nb::arg("kernel"), nb::arg("centres"), nb::arg("weights"), nb::arg("affine"), nb::arg("places"));
  module.def("parameters", &py::parameters);
}
