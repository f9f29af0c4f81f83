// SPDX-License-Identifier: MIT
#include "fuzz/target.h"
#include "homolog/shape/label_surface.h"
#include "homolog/shape/read_metaimage.h"
#include "homolog/shape/read_nifti.h"
#include "homolog/shape/read_nrrd.h"
#include "shape/volume_files.h"

namespace homolog::fuzz {
namespace {

const ReadLimits limits{most_bytes, 0, 300};     // the seeds have 240 voxels
constexpr std::uint64_t most_with_surface = 12;  // surfaces of more take the time of many files

std::string read_other(const std::string&) { return volumes::voxels(); }

/// A reader of volumes keeps the promises of a mesh reader through the surface of all labels.
template <class Read>
std::function<void(const std::string&)> runs(const Read& read) {
  return [read](const std::string& bytes) {
    run_mesh_reader(
        [&](const std::string& content, const std::string& file) {
          const RawVolume volume = read(content, file);
          require(volume.bytes.size() == volume.voxels() * bytes_of(volume.type), "all voxels are there");
          require(volume.voxels() <= limits.voxels, "no more voxels than allowed");
          return volume.voxels() > most_with_surface ? Mesh() : label_surface(volume, 0, file);
        },
        bytes);
  };
}

}  // namespace

Target nifti() {
  return {"nifti",
          {volumes::nifti(), volumes::nifti(false, std::endian::big), volumes::nifti2(), volumes::compressed(volumes::nifti(), true)},
          runs([](const std::string& bytes, const std::string& file) { return read_nifti(bytes, file, limits); })};
}

Target nrrd() {
  return {"nrrd",
          {volumes::nrrd(), volumes::nrrd(true, false), volumes::nrrd(false, true, "data file: voxels.raw\nbyte skip: -1\n", ""),
           "NRRD0001\ntype: double\ndimension: 3\nsizes: 1 1 1\nspacings: 1 2 3\nendian: big\nencoding: raw\n\n\x3f\xf0\1\1\1\1\1\1"},
          runs([](const std::string& bytes, const std::string& file) { return read_nrrd(bytes, file, limits, read_other); })};
}

Target metaimage() {
  return {"metaimage",
          {volumes::metaimage(), volumes::metaimage(true), volumes::metaimage(false, "voxels.raw"),
           "NDims = 3\nDimSize = 1 1 1\nHeaderSize = -1\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n\1"},
          runs([](const std::string& bytes, const std::string& file) { return read_metaimage(bytes, file, limits, read_other); })};
}

}  // namespace homolog::fuzz
