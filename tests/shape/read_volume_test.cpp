// SPDX-License-Identifier: MIT
// Volume files through read_mesh(): the surface of the label must lie where the header says.
#include <gtest/gtest.h>

#include <limits>

#include "shape/volume_test_files.h"

namespace homolog {
namespace {

using ReadVolume = VolumeTest;

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

TEST_F(ReadVolume, WhatIsOnlyNamedAsAVolumeIsTold) {
  std::string nameless = volumes::nifti();
  nameless[344] = 0;  // magic
  expect_error("a.nii", nameless, "it does not begin as .nii files do");
  for (const char* name : {"b.nrrd", "c.nhdr", "d.mha", "e.mhd"}) expect_error(name, std::string(400, '\0'), "it does not begin as");
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
  write("empty.raw", "");
  expect_error("g.nhdr", volumes::nrrd(false, true, "data file: .\n", ""), "it needs the file '.', but that is a directory");
  expect_error("h.mhd", volumes::metaimage(false, "empty.raw"), "it needs the file 'empty.raw', but the file is empty");
}

TEST_F(ReadVolume, TheLabelIsChosenOrAskedFor) {
  const std::string both = volumes::nifti(true, std::endian::little, volumes::voxels(true));
  expect_error("a.nii", both, "it holds the labels 1, 2; say which one is meant by its label (0 for all), or save that one alone");
  expect_box_of_ones(read_mesh(write("a.nii", both), {}, 1));
  const Box twos = bounding_box(read_mesh(write("a.nii", both), {}, 2)), all = bounding_box(read_mesh(write("a.nii", both), {}, 0));
  EXPECT_NEAR(twos.min.x(), -10 - 2 * 6.5, 0.2);
  EXPECT_NEAR(twos.max.x(), -10 - 2 * 4.5, 0.2);
  EXPECT_NEAR(all.max.x() - all.min.x(), 2 * 6, 2 * 2 * 0.2);
  EXPECT_THROW(read_mesh(write("a.nii", both), {}, 3), FileError);
  try {
    read_mesh(write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), {}, 3);
    ADD_FAILURE() << "no FileError";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("a.off: it holds no labels; leave the label out"), std::string::npos) << error.what();
  }
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
  expect_error("a.nii", with_slope(1e17f), "but labels are read up to 1000000000000000; number them anew, or segment the scan first");
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
  expect_error("a.nii", file(inverted), "save the shape as a label of its own, or name this label");
  EXPECT_FALSE(read_mesh(write("a.nii", file(inverted)), {}, 1).triangles.empty());
  EXPECT_FALSE(read("b.nii", file(block)).triangles.empty()) << "a block is one, even if nothing is left around it";
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
