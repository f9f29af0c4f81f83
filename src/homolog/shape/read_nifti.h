// SPDX-License-Identifier: MIT
// NIfTI-1 and NIfTI-2 volumes in one file, plain or gzipped [cox2004]. Read by ourselves: the header has a dozen fields that matter, and
// Debian's libnifti takes truncated files for whole ones.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/raw_volume.h"

namespace homolog {

/// Whether these are the bytes of a NIfTI file, compressed or not. Throws FileError, with the name, when compressed bytes are damaged.
bool is_nifti(std::string_view content, const std::string& file);

/// The volume in the bytes of a NIfTI file; `file` is its name for messages. World coordinates are those of the sform, else of the qform,
/// else of the voxel sizes alone, turned to LPS. Throws FileError (truncated, malformed, not one volume of three dimensions, more voxels
/// than allowed).
RawVolume read_nifti(std::string_view content, const std::string& file, const ReadLimits& limits);

}  // namespace homolog
