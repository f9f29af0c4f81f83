// SPDX-License-Identifier: MIT
#include "fuzz/target.h"
#include "homolog/shape/read_obj.h"
#include "homolog/shape/read_obj_attributes.h"

namespace homolog::fuzz {
namespace {

/// Every file that it names is there, and holds the same bytes. The numbers of UVs and materials exist.
Mesh read_mesh_of_attributes(const std::string& bytes, const std::string& file) {
  const AttributedMesh mesh = read_obj_attributes(bytes, file, [&](const std::string&) { return bytes; });
  const Texturing& texturing = mesh.texturing;
  for (std::size_t t = 0; t < texturing.corners.size(); ++t) {
    for (const std::uint32_t corner : texturing.corners[t]) require(!texturing.has_uvs(t) || corner < texturing.uvs.size(), "UVs exist");
    require(texturing.material_of[t] < static_cast<int>(texturing.materials.size()), "materials exist");
  }
  for (const Material& material : texturing.materials) require(material.image < static_cast<int>(texturing.images.size()), "images exist");
  require(texturing.corners.empty() || texturing.corners.size() == mesh.mesh.triangles.size(), "every triangle has corners, or none");
  return mesh.mesh;
}

void require_sentence(const std::string& told) { require(!told.empty() && told.find('\n') == told.npos, "what is told is one line"); }

}  // namespace

Target obj() {
  return {
      "obj",
      {"mtllib a.mtl\nnewmtl a b\nKd 1 .5 0\nd .5\nmap_Kd -s 1 1 1 a.png\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 "
       "1\nvt 0 0\nvt 1\n"
       "usemtl a b\nf 1/1 2/2 3/-1/1 4/1\nusemtl c\nf 1 2 3\n",
       "mtllib a.mtl\no box\nv 0 0 0\nv 1 0 0 1\nv 1 1 0\nv 0 1 .25\nvn 0 0 1\nvt 0 0\nf 1/1/1 2/1/1 3/1/1\nf -1//1 -2//1 -4//1\n",
       "# a polygon over two lines, and a corner that comes later\nv 0 0 0\nv 2 0 0\nf 1 2 \\\n3 4 5\nv 2 2 0\nv 1 .5 0\nv 0 2 0\n",
       "v 0 0 0\r\nv 1e300 0 0\r\nv 0 -1e-300 0\r\nfo 1 2 3\r\nl 1 2\r\np 1\r\n", "v 1 2 3\nf 1 2 3\n", "f 0 0 0\nsurf 0 1 0 1 1 2 3\n"},
      [](const std::string& bytes) {
        run_mesh_reader([](const std::string& content, const std::string& file) { return read_obj(content, file, require_sentence); },
                        bytes);
        run_mesh_reader(read_mesh_of_attributes, bytes);
      }};
}

}  // namespace homolog::fuzz
