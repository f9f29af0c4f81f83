// SPDX-License-Identifier: MIT
#include "homolog/shape/read_vtk.h"

#include "homolog/shape/text.h"
#include "shape/files.h"
#include "shape/vtk_files.h"

namespace homolog {
namespace {

using ReadVtk = FileTest;

const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {.5, .5, 1}};
using Triangles = std::vector<std::array<std::uint32_t, 3>>;
const Triangles polygons{{0, 3, 2}, {0, 2, 1}, {0, 1, 4}, {1, 2, 4}}, strip{{2, 3, 4}, {3, 0, 4}};

std::string with(std::string text, const std::string& old, const std::string& other) {
  return text.replace(text.find(old), old.size(), other);
}

TEST_F(ReadVtk, ReadsPolygonsAndStripsOfAllVersions) {
  Triangles all = polygons;
  all.insert(all.end(), strip.begin(), strip.end());
  for (const std::string& content : {vtk::legacy(false), vtk::legacy(true), vtk::legacy5(false), vtk::legacy5(true), vtk::legacy_grid()}) {
    const Mesh mesh = read("a.vtk", content);
    EXPECT_EQ(mesh.vertices, corners);
    EXPECT_EQ(mesh.triangles, all);
  }
}

// As VTK itself does.
TEST_F(ReadVtk, ReadsItsWordsInSmallLettersToo) {
  for (const std::string& content : {vtk::legacy(false), vtk::legacy5(false), vtk::legacy_grid()}) {
    const std::size_t behind_title = content.find("ASCII");
    EXPECT_EQ(read("a.vtk", content.substr(0, behind_title) + lower(content.substr(behind_title))).vertices, corners);
  }
}

TEST_F(ReadVtk, IsKnownByItsBeginning) {
  EXPECT_EQ(read("a.obj", vtk::legacy(false)).triangles.size(), 6u);
  EXPECT_FALSE(is_vtk("OFF\n"));
}

TEST_F(ReadVtk, KnowsMeshesThatStateRasInTheTitleOrAField) {
  EXPECT_FALSE(read("a.vtk", vtk::legacy(false)).ras);
  for (const bool binary : {false, true}) {
    const std::string text = vtk::legacy(binary), old = std::string("name 1 1 string\n") + (binary ? "\xc4" : "") + "a%20",
                      field = std::string("SPACE 1 1 string\n") + (binary ? "\xc3" : "");
    EXPECT_TRUE(read("a.vtk", with(text, "a pyramid", "3D Slicer output. SPACE=RAS")).ras);
    EXPECT_TRUE(read("a.vtk", with(text, old, field + "RAS")).ras);
    EXPECT_FALSE(read("a.vtk", with(text, old, field + "LPS")).ras);
  }
}

TEST_F(ReadVtk, RefusesOtherDataAndSolidCells) {
  expect_error("a.vtk", with(vtk::legacy(false), "POLYDATA", "STRUCTURED_POINTS"), "STRUCTURED_POINTS are not read");
  expect_error("a.vtk", vtk::legacy_grid("10 5 5 6 1"), "type 10");
}

TEST_F(ReadVtk, RefusesDamagedFiles) {
  const std::string text = vtk::legacy(false), grid = vtk::legacy_grid();
  expect_error("a.vtk", with(text, "ASCII", "TEXT"), "ASCII or BINARY");
  expect_error("a.vtk", with(text, "DATASET", "DATA"), "DATASET is missing");
  expect_error("a.vtk", with(text, "POINTS 5 double", "POINTS 5 variant"), "'variant' are not read");
  expect_error("a.vtk", with(text, "POINTS 5", "POINTS 99999999999"), "too short");
  expect_error("a.vtk", with(text, "POINTS 5", "POINTS -5"), "cannot be -5");
  expect_error("a.vtk", with(text, "POINTS 5", "POINTS 4"), "not a word of polygonal data");
  expect_error("a.vtk", with(text, "0.5", "nan"), "not a finite number");
  expect_error("a.vtk", with(text, "POLYGONS 3 13", "POLYGONS 4 13"), "cell 3 does not fit");
  expect_error("a.vtk", with(text, "4 0 3 2 1", "4 0 3 2 5"), "names point 5, but there are 5");
  expect_error("a.vtk", with(text, "4 0 3 2 1", "4 0 3 2 -1"), "names point -1");
  expect_error("a.vtk", with(grid, "CELL_TYPES 5", "CELL_TYPES 4"), "not a word");
  expect_error("a.vtk", grid.substr(0, grid.find("CELL_TYPES")), "5 cells, but 0 types");
  const std::string offsets = vtk::legacy5(false);
  expect_error("a.vtk", with(offsets, "0 4 7 10", "0 4 3 10"), "cell 1: it does not end behind its beginning");
  expect_error("a.vtk", with(offsets, "0 4 7 10", "0 4 7 11"), "cell 2: it does not end");
  expect_error("a.vtk", with(offsets, "CONNECTIVITY", "CONNECTED"), "CONNECTIVITY is missing");
  for (const bool binary : {false, true}) {
    const std::string whole = vtk::legacy(binary);
    for (const std::size_t length : {60u, 120u, 160u, 200u}) EXPECT_THROW(read("a.vtk", whole.substr(0, length)), FileError);
  }
}

}  // namespace
}  // namespace homolog
