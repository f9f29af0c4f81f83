// SPDX-License-Identifier: MIT
#include "fuzz/target.h"
#include "homolog/outputs/read_points.h"

namespace homolog::fuzz {
namespace {

void run(const std::string& bytes) {
  try {
    for (const MarkupPoint& point : read_points_csv(bytes, "fuzzed")) {
      require(!point.position || point.position->allFinite(), "coordinates are finite");
    }
  } catch (const FileError& error) {
    return require_one_line(error);
  }
}

}  // namespace

Target points_csv() {
  return {"points_csv",
          {"label,x,y,z\nnose,0,1.3,-9.8e-1\n\"a, \"\"b\"\"\",1,2,3\ngone,,NA,\n", "z , x,other, y\r\n3,1,,2\r\n\r\n", "x,y,z\n1,2\n",
           "label\n", "x,y,z\n\"1,2,3\n"},
          run};
}

}  // namespace homolog::fuzz
