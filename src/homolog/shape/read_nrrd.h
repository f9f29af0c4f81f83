// SPDX-License-Identifier: MIT
// NRRD volumes, version 1 to 5: .nrrd, and .nhdr with the voxels in a file of their own [kindlmann2004].
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/raw_volume.h"

namespace homolog {

bool is_nrrd(std::string_view content);

/// The volume in the bytes of a NRRD file; `file` is its name for messages. The spaces RAS and LAS are turned to LPS, all others stay.
/// Throws FileError (truncated, malformed, not of three dimensions, encodings other than raw and gzip, more voxels than allowed).
RawVolume read_nrrd(std::string_view content, const std::string& file, const ReadLimits& limits, const ReadOther& read_other);

}  // namespace homolog
