// SPDX-License-Identifier: MIT
#include "homolog/shape/read_3mf.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "homolog/base/errors.h"
#include "homolog/shape/slicer_parts.h"
#include "homolog/shape/text.h"
#include "homolog/shape/xml.h"
#include "homolog/shape/zip_archive.h"

namespace homolog {
namespace {

constexpr std::string_view model_relation = "/3dmodel";
constexpr int deepest = 64;                                                                                  // of components in components
constexpr std::size_t most_placed = 100'000;                                                                 // objects
constexpr std::string_view known_extensions[] = {"/core/", "/production/", "/material/", "/trianglesets/"};  // the last two say no form

/// An object where it stands, perhaps in another part of the archive.
struct Placed {
  std::string part, object;
  Mat4 outer_from_object = Mat4::Identity();
};

struct Object {
  Mesh mesh;
  std::vector<Placed> components;
  bool is_left_out = false, has_beams = false;
};

struct Model {
  std::map<std::string, Object, std::less<>> objects;
  std::vector<Placed> items;
};

[[noreturn]] void fail(const std::string& file, const std::string& what) {
  throw FileError(fmt::format("{}: {}; the file is damaged, export it again", file, what));
}

/// The name of a part in the archive, which knows no first slash.
std::string part_of(std::string_view path) { return std::string(path.substr(path.starts_with('/') ? 1 : 0)); }

/// Twelve numbers, for row vectors; none: nothing moves.
Mat4 transform_of(const XmlElement& element, const std::string& file) {
  std::string_view words = element.attribute("transform");
  Mat4 matrix = Mat4::Identity();
  if (words.empty()) return matrix;
  Text text{file, {}, element.line};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 3; ++column) matrix(column, row) = take_number(text, words, "a number of a transform");
  }
  return matrix;
}

double coordinate(const XmlElement& element, std::string_view key, const std::string& file) {
  std::string_view word = element.attribute(key);
  Text text{file, {}, element.line};
  return take_number(text, word, "a vertex coordinate");
}

/// Fills a model from the elements of its part.
class Reader {
 public:
  Reader(std::string part, const std::string& file, std::size_t most_triangles)
      : part_(std::move(part)), file_(file), most_triangles_(most_triangles) {}

  bool begin(const XmlElement& element) {
    if (element.name == "model") {
      check_extensions(element);
    } else if (element.name == "object") {
      object_ = &model.objects[std::string(element.attribute("id"))];
      const std::string_view type = element.attribute("type");
      object_->is_left_out = type == "other" || type == "support" || type == "solidsupport";
    } else if (element.name == "item") {
      if (element.attribute("printable") != "0") model.items.push_back(placed(element));
    } else if (object_ && element.name == "component") {
      object_->components.push_back(placed(element));
    } else if (object_ && element.name == "vertex") {
      object_->mesh.vertices.emplace_back(coordinate(element, "x", file_), coordinate(element, "y", file_),
                                          coordinate(element, "z", file_));
    } else if (object_ && element.name == "triangle") {
      add_triangle(element);
    } else if (object_ && element.name == "beam") {
      object_->has_beams = true;
    }
    return true;
  }

  Model model;

 private:
  /// A model names extensions without which it is something else, by the prefixes of their namespaces.
  void check_extensions(const XmlElement& element) const {
    std::string_view prefixes = element.attribute("requiredextensions");
    for (std::string_view prefix = take_word(prefixes); !prefix.empty(); prefix = take_word(prefixes)) {
      const std::string_view name = element.attribute(prefix);
      const bool is_known = std::any_of(std::begin(known_extensions), std::end(known_extensions), [&](std::string_view known) {
        return name.starts_with("http://schemas.microsoft.com/3dmanufacturing/") && name.find(known) != name.npos;
      });
      if (!is_known) {
        throw FileError(fmt::format("{}: it needs the extension '{}', which is not read; export it without", file_,
                                    shown(name.empty() ? prefix : name, 100)));
      }
    }
  }

  Placed placed(const XmlElement& element) const {
    const std::string_view path = element.attribute("path");
    return {path.empty() ? part_ : part_of(path), std::string(element.attribute("objectid")), transform_of(element, file_)};
  }

  /// All vertices of an object stand before its triangles.
  void add_triangle(const XmlElement& element) {
    Mesh& mesh = object_->mesh;
    std::array<std::uint32_t, 3> corners{};
    constexpr std::string_view keys[] = {"v1", "v2", "v3"};
    for (std::size_t k = 0; k < 3; ++k) {
      std::string_view word = element.attribute(keys[k]);
      Text text{file_, {}, element.line};
      const long long corner = take_integer(text, word, "a vertex number");
      if (corner < 0 || corner >= static_cast<long long>(mesh.vertices.size())) {
        fail(file_, fmt::format("vertex {} does not exist (the object has {}, counted from 0)", corner, mesh.vertices.size()));
      }
      corners[k] = static_cast<std::uint32_t>(corner);
    }
    if (mesh.triangles.size() >= most_triangles_) {
      throw FileError(fmt::format("{}: it holds more than the {} triangles that are read; simplify the mesh", file_, most_triangles_));
    }
    mesh.triangles.push_back(corners);
  }

  std::string part_;
  const std::string& file_;
  std::size_t most_triangles_;
  Object* object_ = nullptr;
};

/// Puts together what the parts of an archive hold; each is read once, when it is named.
class Assembly {
 public:
  Assembly(const ZipArchive& archive, const std::string& file, const ReadLimits& limits)
      : archive_(archive),
        file_(file),
        limits_(limits),
        bytes_left_(limits.bytes),
        no_solids_(no_solid_parts(archive, file, limits.bytes)) {}

  const Model& model(const std::string& part) {
    if (const auto known = models_.find(part); known != models_.end()) return known->second;
    const std::optional<std::string> text = archive_.read(part, bytes_left_);
    if (!text) fail(file_, fmt::format("its part '{}' is missing", shown(part, 100)));
    bytes_left_ -= text->size();
    Reader reader(part, file_, limits_.triangles);
    read_xml(*text, file_, {[&](const XmlElement& element) { return reader.begin(element); }});
    for (const auto& [id, parts] : no_solids_) {
      if (const auto object = reader.model.objects.find(id); object != reader.model.objects.end())
        leave_out(object->second.mesh, parts, file_);
    }
    return models_.emplace(part, std::move(reader.model)).first->second;
  }

  void add(const Placed& placed, const Mat4& world_from_outer, int depth) {
    if (depth > deepest || ++placed_ > most_placed) fail(file_, "its objects hold each other too often");
    const Model& holder = model(placed.part);
    const auto found = holder.objects.find(placed.object);
    if (found == holder.objects.end()) fail(file_, fmt::format("object '{}' does not exist", shown(placed.object)));
    const Object& object = found->second;
    if (object.is_left_out) return;
    has_beams = has_beams || object.has_beams;
    const Mat4 world_from_object = world_from_outer * placed.outer_from_object;
    append(object.mesh, world_from_object);
    for (const Placed& component : object.components) add(component, world_from_object, depth + 1);
  }

  Mesh mesh;
  bool has_beams = false;

 private:
  void append(const Mesh& part, const Mat4& world_from_object) {
    const std::size_t first = mesh.vertices.size();
    if (mesh.triangles.size() + part.triangles.size() > limits_.triangles || first + part.vertices.size() > 3 * limits_.triangles) {
      throw FileError(fmt::format("{}: it holds more than the {} triangles that are read; simplify the mesh", file_, limits_.triangles));
    }
    for (const Vec3& vertex : part.vertices) {
      mesh.vertices.push_back((world_from_object * vertex.homogeneous()).head<3>());
      if (!mesh.vertices.back().allFinite()) fail(file_, "a coordinate is not a finite number");
    }
    const auto offset = static_cast<std::uint32_t>(first);
    for (const auto& [a, b, c] : part.triangles) mesh.triangles.push_back({offset + a, offset + b, offset + c});
  }

  const ZipArchive& archive_;
  const std::string& file_;
  const ReadLimits& limits_;
  std::map<std::string, Model> models_;
  std::size_t placed_ = 0;
  std::uint64_t bytes_left_;  // to be unpacked
  const std::map<std::string, std::vector<TriangleRange>> no_solids_;
};

/// The part that the archive says to begin with.
std::string root_part(const ZipArchive& archive, const std::string& file, std::uint64_t most) {
  std::string root;
  const std::optional<std::string> relations = archive.read("_rels/.rels", most);
  if (!relations) fail(file, "this is an archive, but not of a 3MF model");
  read_xml(*relations, file, {[&](const XmlElement& element) {
    if (element.name == "Relationship" && element.attribute("Type").ends_with(model_relation)) {
      root = part_of(element.attribute("Target"));
    }
    return root.empty();
  }});
  if (root.empty()) fail(file, "it names no 3D model");
  return root;
}

}  // namespace

bool is_3mf(std::string_view content) {
  return content.starts_with("PK\3\4") && content.find("_rels/.rels") != content.npos && content.find(".model") != content.npos;
}

Mesh read_3mf(std::string_view content, const std::string& file, const ReadLimits& limits, const Tell& tell) {
  const ZipArchive archive(content, file);
  Assembly assembly(archive, file, limits);
  const Model& root = assembly.model(root_part(archive, file, limits.bytes));
  if (root.items.empty())
    throw FileError(fmt::format("{}: none of its objects is to be built; put them on the plate and export it again", file));
  for (const Placed& item : root.items) assembly.add(item, Mat4::Identity(), 0);
  if (assembly.has_beams && tell) tell("its beams (beamlattice) are left out; make triangles of them and export it again");
  return std::move(assembly.mesh);
}

}  // namespace homolog
