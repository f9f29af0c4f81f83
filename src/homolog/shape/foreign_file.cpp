// SPDX-License-Identifier: MIT
#include "homolog/shape/foreign_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "homolog/base/errors.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

using namespace std::string_view_literals;

struct Kind {
  std::string_view begin, what;
};

/// By their endings: volumes of other programs, which begin like anything.
constexpr Kind endings[] = {
    {".mgz", "a volume of FreeSurfer; save it as NIfTI (mri_convert)"},
    {".mgh", "a volume of FreeSurfer; save it as NIfTI (mri_convert)"},
    {".hdr", "the header of a volume, or a picture; save header and voxels as one .nii"},
    {".img", "the voxels of a volume without their header; save both as one .nii"},
};

constexpr Kind kinds[] = {
    {"version https://git-lfs", "the placeholder of a large file in git; fetch the file itself (git lfs pull)"},
    {"\x1f\x8b"sv, "compressed by gzip; unpack it first"},
    {"BZh"sv, "compressed by bzip2; unpack it first"},
    {"\xfd\x37zXZ"sv, "compressed by xz; unpack it first"},
    {"7z\xbc\xaf"sv, "a 7z archive; unpack it first"},
    {"Rar!"sv, "a RAR archive; unpack it first"},
    {"(\xb5/\xfd"sv, "compressed by zstd, as Blender may save its files; unpack it, or export the mesh as PLY or glTF"},
    {"\xff\xfe\xff\x0eS\0k\0e\0t\0c\0h\0U\0p"sv, "a SketchUp file; export the mesh from there as COLLADA or STL"},
    {"ISO-10303-21"sv, "a STEP file of a CAD program; export its surface from there as STL or 3MF"},
    {"BLENDER"sv, "a Blender file; export the mesh from Blender as PLY or glTF"},
    {"PXR-USDC"sv, "a USD file; export the mesh as glTF or PLY, from Blender, say"},
    {"#usda"sv, "a USD file; export the mesh as glTF or PLY, from Blender, say"},
    {"#VRML"sv, "a VRML file; save the mesh as PLY or OBJ, from MeshLab, say"},
    {"# .PCD"sv, "a PCD file; save its points with normals as PLY, from CloudCompare, say"},
    {"LASF"sv, "a LAS file; save its points with normals as PLY, from CloudCompare, say"},
    {"$MeshFormat"sv, "a Gmsh file; export its surface from there as STL"},
    {"\x89PNG"sv, "a picture; name a mesh"},
    {"\xff\xd8\xff"sv, "a picture; name a mesh"},
    {"%PDF"sv, "a PDF document; name a mesh"},
    {"{\"error\""sv, "what a server says instead of a file; download the file again"},
};

/// Anywhere in a text that begins with a tag.
constexpr Kind tags[] = {
    {"<!doctype html", "a web page, as failed downloads leave it; download the file again"},
    {"<html", "a web page, as failed downloads leave it; download the file again"},
    {"<x3d", "an X3D file; save the mesh as PLY or glTF, from Blender, say"},
    {"<gifti", "a GIFTI file; save the surface as PLY or STL"},
};

[[noreturn]] void refuse(const std::string& file, std::string_view what) { throw FileError(fmt::format("{}: this is {}", file, what)); }

void refuse_markup(std::string_view start, const std::string& file) {
  const std::string text = lower(start);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos || text[first] != '<') return;
  for (const Kind& kind : tags) {
    if (text.find(kind.begin) != std::string::npos) refuse(file, kind.what);
  }
}

void refuse_zip(std::string_view start, const std::string& extension, const std::string& file) {
  if (!start.starts_with("PK\3\4") || extension == ".3mf") return;
  if (extension == ".usdz") refuse(file, "a USD file; export the mesh as glTF or PLY, from Blender, say");
  refuse(file, "a zip archive; unpack it first");
}

/// As it begins without a mark: every other byte is 0. Headers of binary STL, of 80 bytes, may be such text.
bool has_zeros_between(std::string_view start) {
  constexpr std::size_t least = 8, enough = 256;
  start = start.substr(0, enough);
  if (start.size() < least) return false;
  for (const std::size_t first : {0, 1}) {
    std::size_t alternating = 0;
    while (alternating < start.size() && (start[alternating] == 0) == (alternating % 2 == first)) ++alternating;
    if (alternating == start.size()) return true;
  }
  return false;
}

bool is_iges(std::string_view start) {
  return start.size() > 80 && start[72] == 'S' && start.substr(73, 7).find_first_not_of(" 01") == std::string_view::npos;
}

}  // namespace

std::string_view without_byte_order_mark(std::string_view content) {
  if (content.starts_with("\xef\xbb\xbf")) content.remove_prefix(3);
  return content;
}

void refuse_utf16(std::string_view start, const std::string& file) {
  if (start.starts_with("\xff\xfe") || start.starts_with("\xfe\xff") || has_zeros_between(start))
    refuse(file, "text in UTF-16; save it as UTF-8");
}

void refuse_foreign(std::string_view start, const std::string& extension, const std::string& file) {
  start = without_byte_order_mark(start.substr(0, telling_bytes));
  for (const Kind& kind : endings) {
    if (extension == kind.begin) refuse(file, kind.what);
  }
  for (const Kind& kind : kinds) {
    if (start.starts_with(kind.begin)) refuse(file, kind.what);
  }
  refuse_utf16(start, file);
  refuse_markup(start, file);
  refuse_zip(start, extension, file);
  if (is_iges(start)) refuse(file, "an IGES file of a CAD program; export its surface from there as STL or 3MF");
  if (start.size() > 132 && start.substr(128, 4) == "DICM")
    refuse(file, "a DICOM file; save the segmentation as NIfTI or NRRD, from 3D Slicer, say");
  const bool is_text = start.find('\0') == std::string_view::npos;
  if (is_text && start.find('\n') == std::string_view::npos && std::count(start.begin(), start.end(), '\r') > 3) {
    refuse(file, "text whose lines end as on old Macs; save it with the line ends of Unix or Windows");
  }
}

}  // namespace homolog
