// SPDX-License-Identifier: MIT
// Volume files through read_mesh(): the surface of the label must lie where the header says.
#include <gtest/gtest.h>

#include <limits>

#include "homolog/shape/label_surface.h"
#include "homolog/shape/orient.h"
#include "shape/files.h"
#include "shape/meshes.h"
#include "shape/volume_files.h"

namespace homolog {
namespace {

using ReadVolume = FileTest;

/// The box of ones in LPS: half a voxel beyond the middles of its outer voxels, but for what smoothing does to so small a box.
void expect_box_of_ones(const Mesh& mesh) {
  const Box box = bounding_box(mesh);
  const Vec3 spacing(2, 3, 4), low(-10 - 2 * 3.5, -20 - 3 * 4.5, 30 + 4 * 0.5), high(-10 - 2 * 0.5, -20 - 3 * 0.5, 30 + 4 * 3.5);
  EXPECT_LT((box.min - low).cwiseQuotient(spacing).cwiseAbs().maxCoeff(), 0.2) << box.min.transpose();
  EXPECT_LT((box.max - high).cwiseQuotient(spacing).cwiseAbs().maxCoeff(), 0.2) << box.max.transpose();
  EXPECT_TRUE(orient(mesh).closed());
  EXPECT_GT(meshes::volume(mesh), 0.5 * (6 * 12 * 12));
}

std::string with_slope(float slope) {
  std::string bytes = volumes::nifti();
  volumes::put<float>(bytes, 112, slope, std::endian::little);  // scl_slope
  return bytes;
}

std::string with_capitals(std::string nrrd) {
  for (const char* word : {"right-anterior-superior", "uchar", "raw", "space directions"}) nrrd[nrrd.find(word)] -= 'a' - 'A';
  return nrrd;
}

TEST_F(ReadVolume, EveryFormatLiesInTheSamePlace) {
  const std::pair<std::string, std::string> files[] = {
      {"a.nii", volumes::nifti()},
      {"b.nii", volumes::nifti(false)},
      {"c.nii", volumes::nifti(true, std::endian::big)},
      {"d.nii.gz", volumes::compressed(volumes::nifti(), true)},
      {"e.nii", volumes::nifti2()},
      {"f.nrrd", volumes::nrrd()},
      {"g.nrrd", volumes::nrrd(true)},
      {"h.nrrd", volumes::nrrd(false, false)},
      {"i.mha", volumes::metaimage()},
      {"j.mha", volumes::metaimage(true)},
      {"two packed ones after each other.nii.gz",
       volumes::compressed(volumes::nifti().substr(0, 400), true) + volumes::compressed(volumes::nifti().substr(400), true)},
      {"no scale.nii", with_slope(std::numeric_limits<float>::quiet_NaN())},
      {"capitals.nrrd", with_capitals(volumes::nrrd())},
      {"called_anything", volumes::nifti()},
  };
  for (const auto& [name, content] : files) {
    SCOPED_TRACE(name);
    expect_box_of_ones(read(name, content));
  }
}

std::string widened(const std::string& voxels, std::size_t bytes) {
  std::string wide;
  for (const char voxel : voxels) wide += voxel + std::string(bytes - 1, '\0');
  return wide;
}

TEST_F(ReadVolume, NrrdTypesHaveManyNames) {
  const std::pair<std::size_t, std::vector<std::string>> names[] = {
      {1, {"signed char", "int8", "int8_t", "uchar", "unsigned char", "uint8", "uint8_t"}},
      {2, {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
      {2, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
      {4, {"int", "signed int", "int32", "int32_t", "uint", "unsigned int", "uint32", "uint32_t"}},
      {8, {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64", "int64_t"}},
      {8, {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}}};
  for (const auto& [bytes, types] : names) {
    for (const std::string& type : types) {
      SCOPED_TRACE(type);
      expect_box_of_ones(read("a.nrrd", volumes::nrrd(false, true, "endian: little\n", widened(volumes::voxels(), bytes), type)));
    }
  }
  expect_error("a.nrrd", volumes::nrrd(false, true, "", volumes::voxels(), "block"), "the type 'block' is not read");
}

TEST_F(ReadVolume, MetaImageIsReadAsOthersWriteIt) {
  std::string tight = volumes::metaimage(false, "Local");
  for (std::size_t at = 0; (at = tight.find(" = ", at)) != tight.npos;) tight.replace(at, 3, "=");
  expect_box_of_ones(read("a.mha", tight + volumes::voxels()));
}

TEST_F(ReadVolume, AQuaternionThatIsTooLongTurnsAsOneOfLengthOne) {
  std::string turned = volumes::nifti(false), longer = turned;
  volumes::put<float>(turned, 256, 1, std::endian::little);  // quatern_b: half a turn about x
  volumes::put<float>(longer, 256, 3, std::endian::little);
  const Box box = bounding_box(read("a.nii", turned)), same = bounding_box(read("b.nii", longer));
  EXPECT_LT((box.min - same.min).norm() + (box.max - same.max).norm(), 1e-9);
}

TEST_F(ReadVolume, VoxelsMayStandInAFileBeside) {
  write("voxels.raw", "skipped" + volumes::voxels());
  expect_box_of_ones(read("a.nhdr", volumes::nrrd(false, true, "data file: voxels.raw\nbyte skip: 7\n", "")));
  expect_box_of_ones(read("b.nhdr", volumes::nrrd(false, true, "data file: voxels.raw\nbyte skip: -1\n", "")));
  write("plain.raw", volumes::voxels());
  expect_box_of_ones(read("c.mhd", volumes::metaimage(false, "plain.raw")));
  write("left (2) knee.raw", volumes::voxels());
  expect_box_of_ones(read("named.mhd", volumes::metaimage(false, "left (2) knee.raw")));
  expect_box_of_ones(read("named.nhdr", volumes::nrrd(false, true, "data file: left (2) knee.raw \n", "")));
  expect_error("list.mhd", volumes::metaimage(false, "LIST 2D"), "several files");
  expect_error("pattern.nhdr", volumes::nrrd(false, true, "data file: knee%03d.raw 1 5 1\n", ""), "several files");
  expect_error("d.mhd", volumes::metaimage(false, "../plain.raw"), "outside its folder");
  expect_error("e.nhdr", volumes::nrrd(false, true, "data file: /etc/passwd\n", ""), "outside its folder");
  expect_error("f.mhd", volumes::metaimage(false, "no\1ne.raw"), "it names the file 'no?ne.raw', which is not there");
}

TEST_F(ReadVolume, TheLabelIsChosenOrAskedFor) {
  const std::string both = volumes::nifti(true, std::endian::little, volumes::voxels(true));
  expect_error("a.nii", both, "it holds the labels 1, 2; say which one is meant (--label N, 0 for all)");
  expect_box_of_ones(read_mesh(write("a.nii", both), {}, 1));
  const Box twos = bounding_box(read_mesh(write("a.nii", both), {}, 2)), all = bounding_box(read_mesh(write("a.nii", both), {}, 0));
  EXPECT_NEAR(twos.min.x(), -10 - 2 * 6.5, 0.2);
  EXPECT_NEAR(twos.max.x(), -10 - 2 * 4.5, 0.2);
  EXPECT_NEAR(all.max.x() - all.min.x(), 2 * 6, 2 * 2 * 0.2);
  EXPECT_THROW(read_mesh(write("a.nii", both), {}, 3), FileError);
  EXPECT_THROW(read_mesh(write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), {}, 3), FileError);
}

TEST_F(ReadVolume, ScaleInAFloatLeavesLabelsWhole) {
  std::string tens = volumes::voxels();
  for (char& voxel : tens) voxel = static_cast<char>(10 * voxel);
  std::string scaled = volumes::nifti(true, std::endian::little, tens);
  volumes::put<float>(scaled, 112, 0.1f, std::endian::little);  // scl_slope: 10 * .1f is not 1
  expect_box_of_ones(read("scaled.nii", scaled));
}

TEST_F(ReadVolume, WhatIsNoLabelVolumeIsRefused) {
  expect_error("a.nii", with_slope(0.5f), "labels are whole numbers");
  expect_error("b.nii", volumes::nifti(true, std::endian::little, std::string(240, '\0')), "all voxels are 0");
  std::string series = volumes::nifti();
  volumes::put<std::int16_t>(series, 40, 4, std::endian::little);
  volumes::put<std::int16_t>(series, 48, 7, std::endian::little);
  expect_error("c.nii", series, "it holds 7 volumes");
  std::string flat = volumes::nifti();
  volumes::put<float>(flat, 280, 0, std::endian::little);
  expect_error("d.nii", flat, "do not span space");
}

TEST_F(ReadVolume, TheBackgroundIsNoShapeUnlessAskedFor) {
  std::string inverted = volumes::voxels(), block(240, '\1');
  for (char& voxel : inverted) voxel = voxel == 0;
  const auto file = [](const std::string& voxels) { return volumes::nifti(true, std::endian::little, voxels); };
  expect_error("a.nii", file(inverted), "the label 1 fills the border of the volume, as a background does");
  EXPECT_FALSE(read_mesh(write("a.nii", file(inverted)), {}, 1).triangles.empty());
  EXPECT_FALSE(read("b.nii", file(block)).triangles.empty()) << "a block is one, even if nothing is left around it";
}

/// A header with a part put in the place of another one.
std::string with(std::string content, const std::string& part, const std::string& other) {
  return content.replace(content.find(part), part.size(), other);
}

TEST_F(ReadVolume, NrrdSpacesAreReadAsTheStandardSpellsThem) {
  const std::string ras = "space: right-anterior-superior", lps = "space: left-posterior-superior";
  for (const char* space : {"RAS", "ras", "Right Anterior Superior", "rightanteriorsuperior", " right-anterior-superior "}) {
    SCOPED_TRACE(space);
    expect_box_of_ones(read("a.nrrd", with(volumes::nrrd(), ras, std::string("space: ") + space)));
  }
  for (const char* space : {"LPS", "left posterior superior", "scanner-xyz", "3D-right-handed", "3D-left-handed"}) {
    SCOPED_TRACE(space);
    expect_box_of_ones(read("a.nrrd", with(volumes::nrrd(false, false), lps, std::string("space: ") + space)));
  }
  const std::string las = with(with(volumes::nrrd(), ras, "space: left anterior superior"), "(2,0,0)", "(-2,0,0)");
  expect_box_of_ones(read("a.nrrd", with(las, "(10,20,30)", "(-10,20,30)")));
  for (const char* space : {"RPS", "LPI", "foo", "\"right-anterior-superior\"", "right-anterior-superior-time", "RAST"}) {
    expect_error("a.nrrd", with(volumes::nrrd(), ras, std::string("space: ") + space),
                 std::string("line 5: the space '") + space + "' is not read");
  }
  expect_box_of_ones(read("a.nrrd", with(volumes::nrrd(false, false), lps, "space dimension: 3")));
  expect_error("a.nrrd", with(volumes::nrrd(), ras, "space dimension: 2"), "a solid needs a space of 3 dimensions");
}

TEST_F(ReadVolume, AxesThatAreNotOfSpaceAreRefused) {
  const std::string kinds = "kinds: domain domain domain";
  expect_box_of_ones(read("a.nrrd", with(volumes::nrrd(), kinds, "kinds: space ??? none")));
  for (const char* kind : {"RGB-color", "vector", "list", "time"}) {
    expect_error("a.nrrd", with(volumes::nrrd(), kinds, std::string("kinds: domain domain ") + kind),
                 std::string("an axis of the kind '") + kind + "' is not one of space");
  }
}

TEST_F(ReadVolume, NumbersTooManyAreNotDropped) {
  const auto refused = [&](const std::string& content, const char* part, const char* other, const char* what) {
    expect_error("a.volume", with(content, part, other), what);
  };
  refused(volumes::nrrd(), "sizes: 8 6 5", "sizes: 8 6 5 7", "'7' stands behind the 3 numbers of this field");
  refused(volumes::nrrd(), "(0,0,4)", "(0,0,4) (5,5,5)", "'5' stands behind the 9 numbers of this field");
  refused(volumes::nrrd(), "20,30)", "20,30,9)", "'9' stands behind the 3 numbers of this field");
  refused(volumes::nrrd(), "dimension: 3", "dimension: 3 4", "'4' stands behind the number of this field");
  refused(volumes::metaimage(), "8 6 5", "8 6 5 9", "'9' stands behind the 3 numbers of this field");
  refused(volumes::metaimage(), "0 0 0 1\n", "0 0 0 1 5 5 5\n", "of this field");
  refused(volumes::metaimage(), "NDims = 3", "NDims = 3 3", "'3' stands behind the number of this field");
}

TEST_F(ReadVolume, MetaImageBooleansAreKnownByTheirFirstLetter) {
  const std::string plain = volumes::metaimage(), packed = volumes::metaimage(true);
  for (const char* yes : {"TRUE", "true", "T", "t", "1"}) {
    SCOPED_TRACE(yes);
    expect_box_of_ones(read("a.mha", with(plain, "BinaryData = True", std::string("BinaryData = ") + yes)));
    expect_box_of_ones(read("a.mha", with(packed, "CompressedData = True", std::string("CompressedData = ") + yes)));
  }
  std::string big = with(plain.substr(0, plain.size() - volumes::voxels().size()), "MSB = False", "MSB = TRUE");
  big = with(big, "MET_UCHAR", "MET_USHORT");
  expect_box_of_ones(read("a.mha", big + '\0' + widened(volumes::voxels(), 2).substr(0, 2 * volumes::voxels().size() - 1)));
  expect_error("a.mha", with(plain, "BinaryData = True", "BinaryData = FALSE"), "its voxels are text");
  expect_error("a.mha", with(plain, "MSB = False", "MSB = yes"), "line 4: 'yes' is neither True nor False");
}

TEST_F(ReadVolume, MetaImageMayHaveManyComments) {
  expect_box_of_ones(read("a.mha", "Comment = a\nComment = b\n" + with(volumes::metaimage(), "NDims", "Comment = c\nNDims")));
}

TEST_F(ReadVolume, NrrdListsOfFilesAreToldAsSuch) {
  for (const char* list : {"LIST", "LIST 2"}) {
    expect_error("a.nhdr", volumes::nrrd(false, true, std::string("data file: ") + list + "\nslice0.raw\nslice1.raw\n", ""),
                 "line 12: the voxels stand in several files");
  }
}

TEST_F(ReadVolume, NrrdSkipsBytesOfWhatIsUnpacked) {
  const std::string header = with(volumes::nrrd(false, true, "byte skip: 7\n", ""), "encoding: raw", "encoding: gzip");
  expect_box_of_ones(read("a.nrrd", header + volumes::compressed("skipped" + volumes::voxels(), true)));
  expect_error("b.nrrd", header + "skipped" + volumes::compressed(volumes::voxels(), true), "truncated or damaged");
  expect_error("c.nrrd", header + volumes::compressed(volumes::voxels(), true), "bytes of voxels are announced");
  const std::string much = with(volumes::nrrd(true), "owner:=nobody", "byte skip: 1000000000000");
  expect_error("d.nrrd", much, "unpacked bytes before the voxels are not skipped");
}

TEST_F(ReadVolume, FieldsThatLackOrStandTwiceAreNamed) {
  expect_error("a.nrrd", volumes::nrrd(false, true, "sizes: 8 6 5\n"), "the field 'sizes' stands twice");
  expect_error("b.mha", "NDims = 3\nNDims = 3\n", "line 2: the field 'NDims' stands twice");
  expect_error("c.mha", "NDims = 3\nElementDataFile = LOCAL\n", "the header lacks the field 'DimSize'");
  expect_error("d.nrrd", "NRRD0004\ndimension: 3\n\n", "the header lacks the field 'sizes'");
  expect_error("e.nrrd", volumes::nrrd(false, true, "axis mins: 1 2 3\n"), "'axis mins' are not read");
}

TEST_F(ReadVolume, TruncatedAndLyingFilesAreRefused) {
  for (const std::string& whole : {volumes::nifti(), volumes::nifti2(), volumes::nrrd(), volumes::metaimage()}) {
    expect_error("a.nii", whole.substr(0, whole.size() - 1), "240 bytes of voxels are announced, but 239 are there");
  }
  const std::string packed = volumes::compressed(volumes::nifti(), true);
  expect_error("b.nii.gz", packed.substr(0, packed.size() / 2), "truncated");
  std::string huge = volumes::nifti();
  for (std::size_t i = 42; i < 48; i += 2) volumes::put<std::int16_t>(huge, i, 32767, std::endian::little);
  expect_error("c.nii", huge, "voxels are more than the");
  EXPECT_THROW(read_mesh(write("d.nii", volumes::nifti()), {most_bytes, 1000, 239}), FileError);
  EXPECT_THROW(read_mesh(write("e.nii.gz", volumes::compressed(volumes::nifti(), true)), {239, 1000, 1000}), FileError)
      << "what is unpacked is larger than the file";
}

}  // namespace
}  // namespace homolog
