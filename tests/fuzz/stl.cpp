// SPDX-License-Identifier: MIT
#include <bit>

#include "fuzz/target.h"
#include "homolog/shape/read_stl.h"

namespace homolog::fuzz {
namespace {

std::string little_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

/// One triangle, and how many the header announces.
std::string binary(std::uint32_t announced, const std::string& comment) {
  std::string bytes = comment + std::string(80 - comment.size(), '\0') + little_endian(announced);
  for (const float value : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) {
    bytes += little_endian(std::bit_cast<std::uint32_t>(value));
  }
  return bytes + std::string(2, '\0');
}

}  // namespace

Target stl() {
  return {"stl",
          {"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e-3 0\nendloop\nendfacet\nendsolid a\n",
           binary(1, "made by hand"), binary(1, "solid it says"), binary(0xffffffff, "a lie"), binary(0, ""), "solid\n"},
          [](const std::string& bytes) { run_mesh_reader(read_stl, bytes); }};
}

}  // namespace homolog::fuzz
