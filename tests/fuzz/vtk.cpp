// SPDX-License-Identifier: MIT
#include "fuzz/target.h"
#include "homolog/shape/read_vtk.h"
#include "homolog/shape/read_vtp.h"
#include "shape/vtk_files.h"

namespace homolog::fuzz {

Target vtk() {
  return {"vtk",
          {vtk::legacy(false), vtk::legacy(true), vtk::legacy5(false), vtk::legacy5(true), vtk::legacy_grid()},
          [](const std::string& bytes) { run_mesh_reader(read_vtk, bytes); }};
}

Target vtp() {
  constexpr std::size_t most_triangles = 10000;
  return {"vtp",
          {vtk::vtp({.ascii = true}), vtk::vtp({.encoded = true}), vtk::vtp({false, true, false, false}),
           vtk::vtp({false, true, true, true}), vtk::vtp({false, true, false, true, std::endian::big}, "RAS"),
           "<Array type=\"String\" Name=\"SPACE\"><VTKFile type=\"PolyData\"/></Array>"},
          [](const std::string& bytes) {
            run_mesh_reader([](const std::string& content, const std::string& file) { return read_vtp(content, file, most_triangles); },
                            bytes);
          }};
}

}  // namespace homolog::fuzz
