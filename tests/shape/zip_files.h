// SPDX-License-Identifier: MIT
// 3MF archives for the tests and fuzz targets, made in code.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace homolog::zip {

inline std::string number(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += i < 8 ? static_cast<char>(value >> 8 * i & 0xff) : '\0';
  return text;
}

/// An archive whose files are not compressed.
inline std::string archive(const std::vector<std::pair<std::string, std::string>>& files) {
  std::string bytes, directory;
  for (const auto& [name, content] : files) {
    const std::uint64_t check = crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size()));
    const std::string head = number(20, 2) + number(0, 8) + number(check, 4) + number(content.size(), 4) + number(content.size(), 4) +
                             number(name.size(), 2) + number(0, 2);
    directory += "PK\1\2" + number(20, 2) + head + number(0, 10) + number(bytes.size(), 4) + name;
    bytes += "PK\3\4" + head + name + content;
  }
  const std::string end = number(files.size(), 2) + number(files.size(), 2) + number(directory.size(), 4) + number(bytes.size(), 4);
  return bytes + directory + "PK\5\6" + number(0, 4) + end + number(0, 2);
}

/// A part with a tetrahedron, and `more` in its resources.
inline std::string model(const std::string& more = "", const std::string& build = R"(<item objectid="1"/>)") {
  return R"(<model unit="inch" xmlns="c" xmlns:p="p"><resources><object id="1"><mesh><vertices><vertex x="0" y="0" z="0"/>)"
         R"(<vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices><triangles>)"
         R"(<triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/><triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/>)"
         "</triangles></mesh></object>" +
         more + "</resources><build>" + build + "</build></model>";
}

/// A part whose object 3 holds its own object 1, and object 1 of the part a.model, moved by 5 in x.
inline std::string assembly() {
  return model(R"(<object id="3"><components><component objectid="1"/><component p:path="/a.model" objectid="1" )"
               R"(transform="1 0 0 0 1 0 0 0 1 5 0 0"/></components></object>)",
               R"(<item objectid="3" transform="0 2 0 -2 0 0 0 0 2 0 0 1"/>)");
}

/// `slicer`: what PrusaSlicer tells of the parts.
inline std::string threemf(const std::string& root, const std::string& beside = "", const std::string& slicer = "") {
  std::vector<std::pair<std::string, std::string>> files{
      {"_rels/.rels", R"(<Relationships><Relationship Target="/3D/root.model" Type="http://x/2013/01/3dmodel"/></Relationships>)"},
      {"3D/root.model", root},
      {"a.model", beside}};
  if (!slicer.empty()) files.emplace_back("Metadata/Slic3r_PE_model.config", slicer);
  return archive(files);
}

}  // namespace homolog::zip
