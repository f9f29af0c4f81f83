// SPDX-License-Identifier: MIT
#include "homolog/shape/read_vtp.h"

#include "shape/files.h"
#include "shape/vtk_files.h"

namespace homolog {
namespace {

using ReadVtp = FileTest;

std::vector<vtk::XmlForm> forms() {
  std::vector<vtk::XmlForm> forms{{.ascii = true}};
  for (const bool appended : {false, true}) {
    for (const bool compressed : {false, true}) {
      for (const std::endian order : {std::endian::little, std::endian::big}) {
        forms.push_back({false, appended, true, compressed, order});
        if (appended) forms.push_back({false, appended, false, compressed, order});
      }
    }
  }
  return forms;
}

std::string with(std::string text, const std::string& old, const std::string& other) {
  return text.replace(text.find(old), old.size(), other);
}

TEST_F(ReadVtp, ReadsArraysHoweverTheyLie) {
  const Mesh expected = read("a.vtk", vtk::legacy(false));
  for (const vtk::XmlForm& form : forms()) {
    const Mesh mesh = read("a.vtp", vtk::vtp(form));
    EXPECT_EQ(mesh.vertices, expected.vertices);
    EXPECT_EQ(mesh.triangles, expected.triangles);
  }
}

TEST_F(ReadVtp, KnowsMeshesThatStateRas) {
  for (const vtk::XmlForm& form : forms()) {
    EXPECT_TRUE(read("a.vtp", vtk::vtp(form, "RAS")).ras);
    EXPECT_FALSE(read("a.vtp", vtk::vtp(form, "LPS")).ras);
    EXPECT_FALSE(read("a.vtp", vtk::vtp(form)).ras);
  }
  expect_error("a.vtp", with(vtk::vtp({.ascii = true}, "RAS"), "82 65", "82 R"), "not a whole number");
}

TEST_F(ReadVtp, ReadsTheFlatCellsOfGrids) {
  const std::string grid =
      "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"3\" NumberOfCells=\"2\"><Points>"
      "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0</DataArray></Points><Cells>"
      "<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 0</DataArray>"
      "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3 4</DataArray>"
      "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5 1</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>";
  EXPECT_EQ(read("a.vtu", grid).triangles.size(), 1u);
  expect_error("a.vtu", with(grid, "5 1", "10 1"), "type 10");
}

TEST_F(ReadVtp, PutsPiecesTogether) {
  const std::string one = vtk::vtp({.ascii = true});
  const std::size_t begin = one.find("<Piece"), end = one.find("</PolyData>");
  const Mesh mesh = read("a.vtp", one.substr(0, end) + one.substr(begin));
  EXPECT_EQ(mesh.vertices.size(), 10u);
  EXPECT_EQ(mesh.triangles.back(), (std::array<std::uint32_t, 3>{8, 5, 9}));
}

// VTK writes what it knows of an array behind its numbers.
TEST_F(ReadVtp, LeavesAloneWhatStandsBehindTheNumbers) {
  const std::string text = vtk::vtp({.ascii = true}), end = "</DataArray>";
  std::string informed = text;
  informed.insert(informed.find(end), "<InformationKey name=\"L2_NORM_RANGE\" length=\"1\"><Value index=\"0\">7</Value></InformationKey>");
  EXPECT_EQ(read("a.vtp", informed).vertices, read("b.vtp", text).vertices);
}

TEST_F(ReadVtp, RefusesWhatItDoesNotRead) {
  const std::string text = vtk::vtp({.ascii = true}), packed = vtk::vtp({false, true, false, true});
  expect_error("a.vtp", with(text, "PolyData", "ImageData"), "of the type ImageData, which is not read");
  expect_error("a.vtp", with(packed, "vtkZLib", "vtkLZ4"), "compressed by vtkLZ4DataCompressor");
  for (const char* more : {"0.5 <!-- half -->", "0&#46;5", "<![CDATA[0.5]]>"})
    expect_error("a.vtp", with(text, "0.5", more),
                 "comments, CDATA or character references stand among its numbers, which are not read; save it with");
  expect_error("a.vtp", with(text, "Float32", "String"), "'String' are not read");
  expect_error("a.vtp", "<?xml version=\"1.0\"?><Array Name=\"SPACE\"><VTKFile type=\"PolyData\"/></Array>", "no triangles");
}

TEST_F(ReadVtp, RefusesDamagedFiles) {
  const std::string text = vtk::vtp({.ascii = true}), packed = vtk::vtp({false, true, false, true}), inside = vtk::vtp({.encoded = true});
  expect_error("a.vtp", text.substr(0, 300), "line 7: it stops being XML here (unclosed token)");
  expect_error("a.vtp", with(text, "NumberOfPoints=\"5\"", "NumberOfPoints=\"x\""), "must be a whole number");
  expect_error("a.vtp", with(text, "NumberOfPoints=\"5\"", "NumberOfPoints=\"99999999999\""), "more than the 150000000 points");
  expect_error("a.vtp", with(text, "NumberOfPoints=\"5\"", "NumberOfPoints=\"6\""), "fewer numbers than it must have");
  expect_error("a.vtp", with(text, "0.5", "nan"), "not a finite number");
  expect_error("a.vtp", with(text, "\"offsets\"", "\"others\""), "Strips offsets is missing");
  expect_error("a.vtp", with(text, "2 3 4 0", "2 3 4 9"), "names point 9, but there are 5");
  expect_error("a.vtp", with(inside, "AAAA", "AA!A"), "not base64");
  expect_error("a.vtp", with(inside, "NumberOfPoints=\"5\"", "NumberOfPoints=\"4\""), "another length");
  expect_error("a.vtp", with(packed, "NumberOfPoints=\"5\"", "NumberOfPoints=\"4\""), "another length");
  expect_error("a.vtp", with(packed, "offset=\"0\"", "offset=\"99999\""), "behind the end");
  expect_error("a.vtp", packed.substr(0, packed.size() - 80), "longer than the file");
  const std::string negative =
      "<VTKFile type=\"PolyData\" header_type=\"Int16\"><PolyData><Piece NumberOfPoints=\"1\"><Points><DataArray type=\"Float32\" "
      "NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/></Points></Piece></PolyData><AppendedData encoding=\"raw\">_\xff\xff"
      "</AppendedData></VTKFile>";
  expect_error("a.vtp", negative, "longer than the file");
}

}  // namespace
}  // namespace homolog
