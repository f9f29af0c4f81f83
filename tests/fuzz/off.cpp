// SPDX-License-Identifier: MIT
#include "fuzz/target.h"
#include "homolog/shape/read_off.h"

namespace homolog::fuzz {

Target off() {
  return {"off",
          {"OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 .5\n0 1 0\n3 0 1 2\n3 0 2 3\n",
           "COFF 5 2 0 # colours\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n2 2 0 0 0 0 0\n0 1 0 0 0 0 0\n.5 .5 0 0 0 0 0\n"
           "5 0 1 2 3 4 1 0 0\n3 0 1 2\n",
           "3 1 0\n-1e300 0 0\n1e-300 +1 0\n0 0 1E+2\n3 0 1 2\n", "OFF BINARY\n", "OFF\n4000000000 4000000000 0\n0 0 0\n"},
          [](const std::string& bytes) { run_mesh_reader(read_off, bytes); }};
}

}  // namespace homolog::fuzz
