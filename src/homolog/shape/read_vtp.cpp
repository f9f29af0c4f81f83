// SPDX-License-Identifier: MIT
#include "homolog/shape/read_vtp.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <utility>

#include "homolog/base/errors.h"
#include "homolog/shape/text.h"
#include "homolog/shape/vtk_array.h"
#include "homolog/shape/vtk_cells.h"
#include "homolog/shape/xml.h"

namespace homolog {
namespace {

/// Arrays by the element around them and their name: "Polys offsets"; that of the points has any name.
struct Piece {
  std::size_t points = 0;
  std::map<std::string, std::size_t, std::less<>> cells;  ///< by the element that holds them
  std::map<std::string, VtkArray, std::less<>> arrays;
};

struct VtpFile {
  VtkStorage storage;
  std::optional<VtkArray> space;  ///< where 3D Slicer writes RAS or LPS
  std::vector<Piece> pieces;
};

constexpr std::pair<std::string_view, std::string_view> counts[] = {
    {"Polys", "NumberOfPolys"}, {"Strips", "NumberOfStrips"}, {"Cells", "NumberOfCells"}};

/// A whole number; 0 if the attribute is not there.
std::size_t number_of(const XmlElement& element, std::string_view key, const std::string& file) {
  const std::string_view word = element.attribute(key);
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (!word.empty() && (error != std::errc() || end != word.data() + word.size())) {
    throw FileError(fmt::format("{}: {} is '{}', but must be a whole number; the file is damaged", file, key, shown(word)));
  }
  return value;
}

NumberType type_of(const XmlElement& element, std::string_view key, NumberType otherwise, const std::string& file) {
  static constexpr std::pair<std::string_view, NumberType> types[] = {
      {"Int8", NumberType::int8},       {"UInt8", NumberType::uint8},    {"Int16", NumberType::int16}, {"UInt16", NumberType::uint16},
      {"Int32", NumberType::int32},     {"UInt32", NumberType::uint32},  {"Int64", NumberType::int64}, {"UInt64", NumberType::uint64},
      {"Float32", NumberType::float32}, {"Float64", NumberType::float64}};
  const std::string_view word = element.attribute(key);
  if (word.empty()) return otherwise;
  for (const auto& [name, type] : types) {
    if (name == word) return type;
  }
  throw FileError(fmt::format("{}: numbers of the type '{}' are not read; save it as PLY", file, shown(word)));
}

VtkStorage storage_of(const XmlElement& element, const std::string& file) {
  const std::string_view kind = element.attribute("type");
  if (kind != "PolyData" && kind != "UnstructuredGrid") {
    throw FileError(
        fmt::format("{}: this is a VTK file of the type {}, which is not read; save a surface as .vtp, or labels as NRRD or "
                    "MetaImage, from ParaView, say",
                    file, shown(kind)));
  }
  const std::endian order = element.attribute("byte_order") == "BigEndian" ? std::endian::big : std::endian::little;
  return {file, order, type_of(element, "header_type", NumberType::uint32, file), std::string(element.attribute("compressor"))};
}

/// The pieces and where their arrays lie.
class Reader {
 public:
  Reader(std::string_view content, const std::string& file) : content_(content) { vtp.storage.file = file; }

  /// False where raw bytes begin, which are no XML.
  bool begin(const XmlElement& element) {
    const std::string& file = vtp.storage.file;
    if (element.name == "VTKFile") vtp.storage = storage_of(element, file);
    if (element.name == "Piece") {
      vtp.pieces.push_back({number_of(element, "NumberOfPoints", file), {}, {}});
      for (const auto& [kind, key] : counts) vtp.pieces.back().cells.emplace(kind, number_of(element, key, file));
    }
    if (element.name == "DataArray" && !vtp.pieces.empty() && !parents_.empty()) add_array(element);
    if (element.name == "Array" && element.attribute("Name") == "SPACE" && !parents_.empty() && parents_.back() == "FieldData") {
      open(element, vtp.space.emplace(VtkArray{NumberType::int8, {}}));
    }
    parents_.emplace_back(element.name);
    if (element.name != "AppendedData") return true;
    const std::size_t mark = content_.find('_', element.inside);
    vtp.storage.appended = content_.substr(std::min(mark, content_.size() - 1) + 1);
    vtp.storage.appended_base64 = element.attribute("encoding") == "base64";
    return false;
  }

  void end(std::size_t place) {
    parents_.pop_back();
    if (open_) open_->text = content_.substr(begin_, std::max(place, begin_) - begin_);
    open_ = nullptr;
  }

  VtpFile vtp;

 private:
  void add_array(const XmlElement& element) {
    const std::string& file = vtp.storage.file;
    const std::string& parent = parents_.back();
    if (parent != "Points" && parent != "Polys" && parent != "Strips" && parent != "Cells") return;
    const VtkArray array{type_of(element, "type", NumberType::none, file), {}};
    if (array.type == NumberType::none) throw FileError(fmt::format("{}: an array has no type; the file is damaged", file));
    const std::string key = parent == "Points" ? parent : fmt::format("{} {}", parent, element.attribute("Name"));
    open(element, vtp.pieces.back().arrays.insert_or_assign(key, array).first->second);
  }

  void open(const XmlElement& element, VtkArray& array) {
    const std::string_view format = element.attribute("format");
    array.binary = format == "binary";
    if (format == "appended") array.appended_at = number_of(element, "offset", vtp.storage.file);
    open_ = &array;
    begin_ = element.inside;
  }

  std::string_view content_;
  std::vector<std::string> parents_;
  VtkArray* open_ = nullptr;
  std::size_t begin_ = 0;
};

std::vector<double> numbers_named(const Piece& piece, const std::string& name, std::size_t count, const VtkStorage& storage) {
  if (count == 0) return {};
  const auto array = piece.arrays.find(name);
  if (array == piece.arrays.end()) {
    throw FileError(fmt::format("{}: the array {} is missing; the file is damaged", storage.file, name));
  }
  return numbers_of(array->second, count, storage);
}

VtkCells cells_named(const Piece& piece, const std::string& kind, const VtkStorage& storage) {
  const std::size_t count = piece.cells.at(kind);
  std::vector<double> ends = numbers_named(piece, kind + " offsets", count, storage);
  const double corners = ends.empty() ? 0 : ends.back();
  if (!(corners >= 0 && corners < 1e12)) {
    throw FileError(fmt::format("{}: the array {} offsets ends with {}; the file is damaged", storage.file, kind, corners));
  }
  VtkCells cells = cells_of_type(kind == "Strips" ? vtk_strip : vtk_polygon,
                                 numbers_named(piece, kind + " connectivity", static_cast<std::size_t>(corners), storage), std::move(ends));
  if (kind == "Cells") cells.types = numbers_named(piece, "Cells types", count, storage);
  return cells;
}

}  // namespace

bool is_vtp(std::string_view content) {
  content.remove_prefix(std::min(content.find_first_not_of(" \t\r\n"), content.size()));
  return content.starts_with("<VTKFile") || (content.starts_with("<?xml") && content.substr(0, 1000).find("<VTKFile") != content.npos);
}

Mesh read_vtp(std::string_view content, const std::string& file, std::size_t most_triangles) {
  Reader reader(content, file);
  read_xml(content, file,
           {[&](const XmlElement& element) { return reader.begin(element); }, [&](std::string_view, std::size_t at) { reader.end(at); }});
  Mesh mesh;
  mesh.ras = reader.vtp.space && first_text_of(*reader.vtp.space, reader.vtp.storage) == "RAS";
  for (const Piece& piece : reader.vtp.pieces) {
    if (piece.points > 3 * most_triangles - std::min(3 * most_triangles, mesh.vertices.size())) {
      throw FileError(fmt::format("{}: it holds more than the {} points that are read; simplify the mesh", file, 3 * most_triangles));
    }
    const VtkStorage& storage = reader.vtp.storage;
    const std::vector<double> points = numbers_named(piece, "Points", 3 * piece.points, storage);
    append_vtk(mesh, points,
               {cells_named(piece, "Polys", storage), cells_named(piece, "Strips", storage), cells_named(piece, "Cells", storage)}, file);
  }
  return mesh;
}

}  // namespace homolog
