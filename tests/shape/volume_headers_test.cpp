// SPDX-License-Identifier: MIT
// What the headers of volume files may say: spellings, kinds, counts, places, and what is refused for it.
#include <gtest/gtest.h>

#include <vector>

#include "shape/volume_test_files.h"

namespace homolog {
namespace {

using VolumeHeaders = VolumeTest;

std::string widened(const std::string& voxels, std::size_t bytes) {
  std::string wide;
  for (const char voxel : voxels) wide += voxel + std::string(bytes - 1, '\0');
  return wide;
}

TEST_F(VolumeHeaders, NrrdTypesHaveManyNames) {
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

TEST_F(VolumeHeaders, NrrdSpacesAreReadAsTheStandardSpellsThem) {
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

TEST_F(VolumeHeaders, AxesThatAreNotOfSpaceAreRefused) {
  const std::string kinds = "kinds: domain domain domain";
  expect_box_of_ones(read("a.nrrd", with(volumes::nrrd(), kinds, "kinds: space ??? none")));
  for (const char* kind : {"RGB-color", "vector", "list", "time"}) {
    expect_error("a.nrrd", with(volumes::nrrd(), kinds, std::string("kinds: domain domain ") + kind),
                 std::string("an axis of the kind '") + kind + "' is not one of space");
  }
}

TEST_F(VolumeHeaders, NrrdListsOfFilesAreToldAsSuch) {
  for (const char* list : {"LIST", "LIST 2"}) {
    expect_error("a.nhdr", volumes::nrrd(false, true, std::string("data file: ") + list + "\nslice0.raw\nslice1.raw\n", ""),
                 "line 12: the voxels stand in several files");
  }
}

TEST_F(VolumeHeaders, NrrdSkipsBytesOfWhatIsUnpacked) {
  const std::string header = with(volumes::nrrd(false, true, "byte skip: 7\n", ""), "encoding: raw", "encoding: gzip");
  expect_box_of_ones(read("a.nrrd", header + volumes::compressed("skipped" + volumes::voxels(), true)));
  expect_error("b.nrrd", header + "skipped" + volumes::compressed(volumes::voxels(), true), "truncated or damaged");
  expect_error("c.nrrd", header + volumes::compressed(volumes::voxels(), true), "bytes of voxels are announced");
  const std::string much = with(volumes::nrrd(true), "owner:=nobody", "byte skip: 1000000000000");
  expect_error("d.nrrd", much, "unpacked bytes before the voxels are not skipped");
}

TEST_F(VolumeHeaders, MetaImageIsReadAsOthersWriteIt) {
  std::string tight = volumes::metaimage(false, "Local");
  for (std::size_t at = 0; (at = tight.find(" = ", at)) != tight.npos;) tight.replace(at, 3, "=");
  expect_box_of_ones(read("a.mha", tight + volumes::voxels()));
}

TEST_F(VolumeHeaders, MetaImageBooleansAreKnownByTheirFirstLetter) {
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

TEST_F(VolumeHeaders, MetaImageMayHaveManyComments) {
  expect_box_of_ones(read("a.mha", "Comment = a\nComment = b\n" + with(volumes::metaimage(), "NDims", "Comment = c\nNDims")));
}

TEST_F(VolumeHeaders, NumbersTooManyAreNotDropped) {
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

TEST_F(VolumeHeaders, FieldsThatLackOrStandTwiceAreNamed) {
  expect_error("a.nrrd", volumes::nrrd(false, true, "sizes: 8 6 5\n"), "the field 'sizes' stands twice");
  expect_error("b.mha", "NDims = 3\nNDims = 3\n", "line 2: the field 'NDims' stands twice");
  expect_error("c.mha", "NDims = 3\nElementDataFile = LOCAL\n", "the header lacks the field 'DimSize'");
  expect_error("d.nrrd", "NRRD0004\ndimension: 3\n\n", "the header lacks the field 'sizes'");
  expect_error("e.nrrd", volumes::nrrd(false, true, "axis mins: 1 2 3\n"), "'axis mins' are not read");
}

TEST_F(VolumeHeaders, AQuaternionMayBeTooLongByRounding) {
  std::string turned = volumes::nifti(false), rounded = turned, longer = turned;
  volumes::put<float>(turned, 256, 1, std::endian::little);  // quatern_b: half a turn about x
  volumes::put<float>(rounded, 256, 1.0000001f, std::endian::little);
  volumes::put<float>(longer, 256, 3, std::endian::little);
  const Box box = bounding_box(read("a.nii", turned)), same = bounding_box(read("b.nii", rounded));
  EXPECT_LT((box.min - same.min).norm() + (box.max - same.max).norm(), 1e-9);
  expect_error("c.nii", longer, "the quaternion in the header is longer than 1");
}

TEST_F(VolumeHeaders, NiftiWithoutAPlaceHasOnlySizes) {
  std::string nowhere = volumes::nifti();
  volumes::put<std::int16_t>(nowhere, 254, 0, std::endian::little);  // sform_code
  const Box box = bounding_box(read("a.nii", nowhere));
  EXPECT_LT((box.max - Vec3(-2 * 0.5, -3 * 0.5, 4 * 3.5)).cwiseAbs().maxCoeff(), 0.8) << box.max.transpose();
  volumes::put<float>(nowhere, 80, -2, std::endian::little);  // pixdim[1]
  expect_error("b.nii", nowhere, "a size of voxels in the header is -2, not above 0");
}

TEST_F(VolumeHeaders, NiftiThatDoesNotSayWhereItsVoxelsBeginHasThemFirst) {
  std::string first = volumes::nifti(), second = volumes::nifti2();
  volumes::put<float>(first, 108, 0, std::endian::little);  // vox_offset
  volumes::put<std::int64_t>(second, 168, 0, std::endian::big);
  expect_box_of_ones(read("a.nii", first));
  expect_box_of_ones(read("b.nii", second));
  expect_box_of_ones(read("c.nii.gz", volumes::compressed(first, true)));
  first[348] = 1;  // extensions stand there
  expect_error("d.nii", first, "the voxels begin at byte 0, which is no place for them");
}

}  // namespace
}  // namespace homolog
