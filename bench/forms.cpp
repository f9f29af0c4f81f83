// SPDX-License-Identifier: MIT
// Sec. 4: whether one object gives the same salient points in whatever form it comes. The first file is the object, the others are the
// same object in other forms, all in the same coordinates; or every file is an object, and its other forms are made of it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "homolog/base/errors.h"
#include "homolog/base/parameters.h"
#include "homolog/salient/salient_points.h"
#include "homolog/shape/read_mesh.h"
#include "homolog/shape/voxelize.h"
#include "other_forms.h"
#include "repeated_points.h"
#include "settings.h"

namespace homolog::bench {
namespace {

struct Form {
  Voxels voxels;
  std::vector<SalientPoint> points;
};

Form form_of(const Mesh& mesh, const Params& params) {
  Form form{voxelize(mesh, params.voxel.resolution, {}, params.voxel.thicken), {}};
  form.points = find_salient_points(form.voxels.interior, params.salient);
  return form;
}

void print_row(const std::string& name, const Form& object, const Form& form) {
  fmt::print("{:32} {:6} {:9.3f} {:8.3f} {:8.3f}\n", name, form.points.size(), form.voxels.guessed,
             repeated_share(object.points, form.points), chance_share(object.points, form.points, object.voxels.interior));
}

std::string name_of(const std::string& file) { return std::filesystem::path(file).filename().string(); }

void print_made_forms(const std::string& file, const Params& params) {
  const Mesh mesh = read_mesh(file);
  const Form object = form_of(mesh, {});
  print_row(name_of(file), object, object);
  for (const NamedMesh& form : other_forms(mesh)) print_row("  " + form.name, object, form_of(form.mesh, params));
}

int run(int argc, char** argv) {
  CLI::App app{"Share of an object's salient points that are found again in other forms of it"};
  std::vector<std::string> files, settings;
  bool make = false;
  app.add_option("files", files, "The object, then its other forms")->required();
  app.add_flag("--make", make, "Make the other forms of every file");
  app.add_option("--param", settings, "NAME=VALUE, a parameter of the forms other than by default (repeatable)")->take_all();
  CLI11_PARSE(app, argc, argv);
  Params params;
  set_parameters(params, settings);
  fmt::print("{:32} {:>6} {:>9} {:>8} {:>8}\n", "form", "points", "guessed", "repeat", "chance");
  if (make) {
    for (const std::string& file : files) print_made_forms(file, params);
    return 0;
  }
  const Form object = form_of(read_mesh(files.front()), {});
  for (const std::string& file : files) print_row(name_of(file), object, form_of(read_mesh(file), params));
  return 0;
}

}  // namespace
}  // namespace homolog::bench

int main(int argc, char** argv) {
  try {
    return homolog::bench::run(argc, argv);
  } catch (const homolog::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
