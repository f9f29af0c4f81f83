// SPDX-License-Identifier: MIT
#include "homolog/shape/read_obj_attributes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "homolog/shape/find_picture.h"
#include "homolog/shape/obj_lines.h"
#include "homolog/shape/polygon.h"
#include "homolog/shape/read_mtl.h"
#include "homolog/shape/read_obj.h"

namespace homolog {
namespace {

/// A face: the numbers of its vertices and of their UVs, which may come later in the file.
struct Face {
  std::size_t line;
  std::vector<std::uint32_t> vertices, uvs;
  int material;
};

struct Reader {
  Text text;
  const FindOther& find_other;
  std::vector<std::string>&missing, &left_out;
  std::size_t vertices = 0;
  std::vector<Rgba> colours = {};  ///< of the vertices so far that have one
  std::vector<Face> faces = {};
  Texturing texturing = {};
  PictureNumbers pictures = {};
  int material = -1;
};

void read_vertex(Reader& reader, std::string_view line) {
  ++reader.vertices;
  take_position(reader.text, line);
  std::array<std::string_view, 3> words;
  for (std::string_view& word : words) word = take_word(line);
  if (words[2].empty()) return;  // nothing, or a weight
  Rgba colour{0, 0, 0, 1};
  for (int k = 0; k < 3; ++k) colour[k] = static_cast<float>(std::clamp(take_number(reader.text, words[k], "a colour"), 0.0, 255.0));
  reader.colours.push_back(colour);
}

void read_face(Reader& reader, std::string_view line) {
  Face face{reader.text.line, {}, {}, reader.material};
  for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
    const std::size_t slash = word.find('/');
    face.vertices.push_back(obj_number(reader.text, word.substr(0, slash), reader.vertices, "vertex"));
    const std::string_view rest = slash == word.npos ? std::string_view() : word.substr(slash + 1);
    const std::string_view uv = rest.substr(0, rest.find('/'));
    if (!uv.empty()) face.uvs.push_back(obj_number(reader.text, uv, reader.texturing.uvs.size(), "texture coordinate"));
  }
  if (face.uvs.size() != face.vertices.size()) face.uvs.clear();
  reader.faces.push_back(std::move(face));
}

/// The number of a material; one that no MTL has is known by its name alone.
int material_number(Texturing& texturing, const std::string& name) {
  auto& materials = texturing.materials;
  const auto found = std::find_if(materials.begin(), materials.end(), [&](const Material& material) { return material.name == name; });
  if (found != materials.end()) return static_cast<int>(found - materials.begin());
  materials.push_back({name, {0.8f, 0.8f, 0.8f, 1}, -1});
  return static_cast<int>(materials.size()) - 1;
}

void read_library(Reader& reader, const std::string& name) {
  const std::optional<std::string> content = reader.find_other(name);
  if (!content) return tell_missing(name, reader.missing);
  const MtlFile mtl = read_mtl(*content, shown(name, longest_name));
  if (!mtl.other_maps.empty()) {
    reader.left_out.push_back(fmt::format("{} of {}", fmt::join(mtl.other_maps, ", "), shown(name, longest_name)));
  }
  if (!mtl.map_options.empty()) {
    reader.left_out.push_back(fmt::format("{} of map_Kd in {}", fmt::join(mtl.map_options, ", "), shown(name, longest_name)));
  }
  for (const auto& [material, picture, has_colour] : mtl.materials) {
    Material& own = reader.texturing.materials[material_number(reader.texturing, material.name)];
    own.colour = material.colour;
    if (picture.empty()) continue;
    own.image = find_picture(picture, reader.find_other, reader.texturing.images, reader.pictures, {reader.missing, reader.left_out});
  }
}

void read_line(Reader& reader, std::string_view line) {
  const std::string_view keyword = take_word(line);
  if (keyword == "v") {
    read_vertex(reader, line);
  } else if (keyword == "vt") {
    const double u = take_number(reader.text, line, "a texture coordinate");
    const bool more = line.find_first_not_of(" \t\r") != line.npos;
    reader.texturing.uvs.push_back({u, more ? take_number(reader.text, line, "a texture coordinate") : 0});
  } else if (keyword == "f" || keyword == "fo") {
    read_face(reader, line);
  } else if (keyword == "usemtl") {
    reader.material = material_number(reader.texturing, rest_of(line));
  } else if (keyword == "mtllib") {
    read_library(reader, rest_of(line));
  }
}

/// Some programs write colours to 255 instead of to 1, others a little more than 1.
std::vector<Rgba> to_one(std::vector<Rgba> colours) {
  float most = 0;
  for (const Rgba& colour : colours) most = std::max({most, colour[0], colour[1], colour[2]});
  const float whole = most > 2 ? 255 : 1;
  for (Rgba& colour : colours) {
    for (int k = 0; k < 3; ++k) colour[k] = std::min(colour[k] / whole, 1.0f);
  }
  return colours;
}

/// The UV numbers of the triangles that a face became.
void append_corners(Reader& reader, const Face& face, const Mesh& triangles, std::size_t first) {
  for (std::size_t t = first; t < triangles.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners{Texturing::no_uv, Texturing::no_uv, Texturing::no_uv};
    for (int k = 0; k < 3 && !face.uvs.empty(); ++k) {
      const auto place = std::find(face.vertices.begin(), face.vertices.end(), triangles.triangles[t][k]) - face.vertices.begin();
      corners[k] = face.uvs[static_cast<std::size_t>(place)];
      if (corners[k] < reader.texturing.uvs.size()) continue;
      reader.text.line = face.line;
      fail(reader.text, fmt::format("texture coordinate {} does not exist (the file has {}); the file is truncated or damaged",
                                    corners[k] + 1ll, reader.texturing.uvs.size()));
    }
    reader.texturing.corners.push_back(corners);
    reader.texturing.material_of.push_back(face.material);
  }
}

}  // namespace

AttributedMesh read_obj_attributes(std::string_view content, const std::string& file, const FindOther& find_other) {
  AttributedMesh mesh;
  mesh.mesh = read_obj(content, file);
  Reader reader{{file, content, 0}, find_other, mesh.missing, mesh.left_out};
  std::string_view line;
  std::string joined;
  while (next_whole_line(reader.text, line, joined)) read_line(reader, line);
  Mesh again{mesh.mesh.vertices, {}};  // cut into triangles as before, face by face
  for (const Face& face : reader.faces) {
    const std::size_t first = again.triangles.size();
    append_polygon(again, face.vertices);
    append_corners(reader, face, again, first);
  }
  if (reader.colours.size() == mesh.mesh.vertices.size()) mesh.colours = to_one(std::move(reader.colours));
  if (!reader.texturing.uvs.empty() || !reader.texturing.materials.empty()) mesh.texturing = std::move(reader.texturing);
  return mesh;
}

}  // namespace homolog
