// SPDX-License-Identifier: MIT
// NRRD volumes, version 1 to 5: .nrrd, and .nhdr with the voxels in a file of their own [kindlmann2004].
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/raw_volume.h"

namespace homolog {

bool is_nrrd(std::string_view content);

/// The volume in the bytes of a NRRD file; `file` is its name for messages. The spaces RAS and LAS are turned to LPS; those that
/// name no directions (scanner-xyz, 3D-right-handed, 3D-left-handed, or none) are taken for it.
/// Throws FileError (truncated, malformed, not of three dimensions of space, other spaces, encodings other than raw and gzip, more voxels
/// than allowed).
RawVolume read_nrrd(std::string_view content, const std::string& file, const ReadLimits& limits, const ReadOther& read_other);

}  // namespace homolog
