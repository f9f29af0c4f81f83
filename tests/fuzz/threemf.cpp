// SPDX-License-Identifier: MIT
// 3MF: a whole archive, and what stands in its parts, put into an archive anew: else little but check sums would be tried.
#include "fuzz/target.h"
#include "homolog/shape/read_3mf.h"
#include "shape/zip_files.h"

namespace homolog::fuzz {
namespace {

const ReadLimits limits{100000, 10000};

Mesh read(const std::string& content, const std::string& file) { return read_3mf(content, file, limits); }

/// The second part begins behind a NUL byte.
void run_parts(const std::string& bytes) {
  const std::size_t end = bytes.find('\0');
  const std::string beside = end == bytes.npos ? std::string() : bytes.substr(end + 1);
  run_mesh_reader(read, zip::threemf(bytes.substr(0, end), beside));
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
           R"(<model xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06" requiredextensions="p q"><build>)"
           R"(<item objectid="1" printable="0"/></build></model>)"},
          run_parts};
}

}  // namespace homolog::fuzz
