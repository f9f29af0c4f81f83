// SPDX-License-Identifier: MIT
#include "fuzz/target.h"
#include "homolog/shape/read_obj.h"

namespace homolog::fuzz {

Target obj() {
  return {"obj",
          {"mtllib a.mtl\no box\nv 0 0 0\nv 1 0 0 1\nv 1 1 0\nv 0 1 .25\nvn 0 0 1\nvt 0 0\nf 1/1/1 2/1/1 3/1/1\nf -1//1 -2//1 -4//1\n",
           "# a polygon over two lines, and a corner that comes later\nv 0 0 0\nv 2 0 0\nf 1 2 \\\n3 4 5\nv 2 2 0\nv 1 .5 0\nv 0 2 0\n",
           "v 0 0 0\r\nv 1e300 0 0\r\nv 0 -1e-300 0\r\nfo 1 2 3\r\nl 1 2\r\np 1\r\n", "v 1 2 3\nf 1 2 3\n", "f 0 0 0\n"},
          [](const std::string& bytes) { run_mesh_reader(read_obj, bytes); }};
}

}  // namespace homolog::fuzz
