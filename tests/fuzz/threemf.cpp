// SPDX-License-Identifier: MIT
// 3MF: a whole archive, and what stands in its parts, put into an archive anew: else little but check sums would be tried.
#include <sstream>

#include "fuzz/target.h"
#include "homolog/shape/read_3mf.h"
#include "shape/zip_files.h"

namespace homolog::fuzz {
namespace {

const ReadLimits limits{100000, 10000};

Mesh read(const std::string& content, const std::string& file) { return read_3mf(content, file, limits); }

/// The second part and what a slicer tells begin behind a NUL byte each.
void run_parts(const std::string& bytes) {
  std::string parts[3];
  std::istringstream rest(bytes);
  for (std::string& part : parts) std::getline(rest, part, '\0');
  run_mesh_reader(read, zip::threemf(parts[0], parts[1], parts[2]));
}

}  // namespace

Target threemf() {
  return {"3mf", {zip::threemf(zip::model()), zip::threemf(zip::assembly(), zip::model())}, [](const std::string& bytes) {
            run_mesh_reader(read, bytes);
          }};
}

Target threemf_parts() {
  return {"3mf_parts",
          {zip::model(), zip::assembly() + '\0' + zip::model(),
           zip::model() + '\0' + '\0' + R"(<config><object id="1"><volume firstid="1" lastid="2"><metadata key="modifier" value="1"/>)" +
               R"(<metadata key="volume_type" value="ParameterModifier"/></volume></object></config>)",
           R"(<model xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06" requiredextensions="p q"><build>)"
           R"(<item objectid="1" printable="0"/></build></model>)"},
          run_parts};
}

}  // namespace homolog::fuzz
