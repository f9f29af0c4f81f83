// SPDX-License-Identifier: MIT
// VTK files for the tests and fuzz targets, made in code: a pyramid of a quadrangle, two triangles and a strip of two more.
#pragma once

#include <fmt/format.h>

#include <vector>

#include "shape/volume_files.h"

namespace homolog::vtk {

inline constexpr std::array<double, 15> points{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, .5, .5, 1};
inline const std::vector<std::int64_t> polygons{0, 3, 2, 1, 0, 1, 4, 1, 2, 4}, polygon_ends{4, 7, 10}, strip{2, 3, 4, 0}, strip_end{4};

template <class T, class Numbers>
std::string bytes_of_numbers(const Numbers& numbers, std::endian order) {
  std::string bytes(sizeof(T) * numbers.size(), '\0');
  for (std::size_t i = 0; i < numbers.size(); ++i) volumes::put(bytes, sizeof(T) * i, static_cast<T>(numbers[i]), order);
  return bytes;
}

template <class Numbers>
std::string words(const Numbers& numbers) {
  std::string text;
  for (const auto number : numbers) text += fmt::format("{}{}", number, text.size() % 40 > 30 ? "\n" : " ");
  return text;
}

/// As up to version 4: cells with their numbers of corners before them.
inline std::string legacy(bool binary) {
  const std::vector<std::int64_t> cells{4, 0, 3, 2, 1, 3, 0, 1, 4, 3, 1, 2, 4}, strips{4, 2, 3, 4, 0};
  const auto body = [&](const auto& numbers) {
    return (binary ? bytes_of_numbers<std::int32_t>(numbers, std::endian::big) : words(numbers)) + "\n";
  };
  return std::string("# vtk DataFile Version 3.0\na pyramid\n") + (binary ? "BINARY" : "ASCII") +
         "\nDATASET POLYDATA\nFIELD FieldData 2\nTimeValue 1 1 int\n" + body(std::vector<std::int64_t>{7}) +
         "METADATA\nINFORMATION 0\n\nname 1 1 string\n" + (binary ? "\xc4" : "") + "a%20\nPOINTS 5 double\n" +
         (binary ? bytes_of_numbers<double>(points, std::endian::big) : words(points)) +
         "\nMETADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1\n\nPOLYGONS 3 13\n" + body(cells) +
         "TRIANGLE_STRIPS 1 5\n" + body(strips) + "LINES 1 3\n" + body(std::vector<std::int64_t>{2, 0, 1}) + "POINT_DATA 5\nwhatever\n";
}

/// As from version 5 on: offsets, then corners.
inline std::string legacy5(bool binary) {
  const auto body = [&](const std::vector<std::int64_t>& numbers) {
    return (binary ? bytes_of_numbers<std::int64_t>(numbers, std::endian::big) : words(numbers)) + "\n";
  };
  const auto cells = [&](std::vector<std::int64_t> ends, const std::vector<std::int64_t>& corners) {
    ends.insert(ends.begin(), 0);
    return fmt::format("{} {}\nOFFSETS vtktypeint64\n", ends.size(), corners.size()) + body(ends) + "CONNECTIVITY vtktypeint64\n" +
           body(corners);
  };
  return std::string("# vtk DataFile Version 5.1\na pyramid\n") + (binary ? "BINARY" : "ASCII") + "\nDATASET POLYDATA\nPOINTS 5 float\n" +
         (binary ? bytes_of_numbers<float>(points, std::endian::big) : words(points)) + "\n\nPOLYGONS " + cells(polygon_ends, polygons) +
         "TRIANGLE_STRIPS " + cells(strip_end, strip);
}

/// An unstructured grid.
inline std::string legacy_grid(const std::string& types = "9 5 5 6 1") {
  return "# vtk DataFile Version 2.0\na pyramid\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 double\n" + words(points) +
         "\nCELLS 5 20\n4 0 3 2 1 3 0 1 4 3 1 2 4 4 2 3 4 0 1 0\nCELL_TYPES 5\n" + types + "\n";
}

inline std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

struct XmlForm {
  bool ascii = false, appended = false, encoded = false, compressed = false;
  std::endian order = std::endian::little;
};

/// An array behind its length, or its compressed halves behind their number and lengths; the two are encoded one by one.
inline std::string stored(const std::string& bytes, const XmlForm& form) {
  std::string head, body = bytes;
  std::vector<std::uint64_t> sizes{bytes.size()};
  if (form.compressed) {
    const std::size_t half = bytes.size() - bytes.size() / 2;
    const std::string first = volumes::compressed(bytes.substr(0, half), false), last = volumes::compressed(bytes.substr(half), false);
    sizes = {2, half, bytes.size() - half, first.size(), last.size()};
    body = first + last;
  }
  head = bytes_of_numbers<std::uint64_t>(sizes, form.order);
  return form.encoded ? base64(head) + base64(body) : head + body;
}

/// Polygonal data as XML. `space`: as 3D Slicer states it.
inline std::string vtp(const XmlForm& form, std::string space = "") {
  std::string appended;
  const auto array = [&](const std::string& type, const std::string& name, const std::string& bytes, const std::string& text) {
    const std::string tag = type == "String" ? "Array" : "DataArray",
                      begin = "<" + tag + " type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"3\" format=\"";
    if (form.ascii) return begin + "ascii\">\n" + text + "\n</" + tag + ">\n";
    if (!form.appended) return begin + "binary\">\n  " + stored(bytes, form) + "\n</" + tag + ">\n";
    const std::size_t offset = appended.size();
    appended += stored(bytes, form);
    return begin + fmt::format("appended\" offset=\"{}\"/>\n", offset);
  };
  const auto numbers = [&](const char* name, const std::vector<std::int64_t>& values) {
    return array("Int64", name, bytes_of_numbers<std::int64_t>(values, form.order), words(values));
  };
  std::string field;
  if (!space.empty()) {
    space += '\0';
    field = "<FieldData>\n" + array("String", "SPACE", space, words(std::vector<int>(space.begin(), space.end()))) + "</FieldData>\n";
  }
  std::string text =
      std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" header_type=\"UInt64\" byte_order=\"") +
      (form.order == std::endian::big ? "BigEndian\"" : "LittleEndian\"") +
      (form.compressed ? " compressor=\"vtkZLibDataCompressor\"" : "") + ">\n<PolyData>\n" + field +
      "<Piece NumberOfPoints=\"5\" NumberOfVerts=\"0\" NumberOfStrips=\"1\" NumberOfPolys=\"3\">\n<PointData/>\n" + "<Points>\n" +
      array("Float32", "Points", bytes_of_numbers<float>(points, form.order), words(points)) + "</Points>\n";
  text += "<Strips>\n" + numbers("connectivity", strip) + numbers("offsets", strip_end) + "</Strips>\n";
  text += "<Polys>\n" + numbers("connectivity", polygons) + numbers("offsets", polygon_ends) + "</Polys>\n</Piece>\n</PolyData>\n";
  if (!form.appended) return text + "</VTKFile>\n";
  return text + "<AppendedData encoding=\"" + (form.encoded ? "base64" : "raw") + "\">\n _" + appended + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace homolog::vtk
