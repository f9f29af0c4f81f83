// SPDX-License-Identifier: MIT
// MetaImage volumes: .mha, and .mhd with the voxels in a file of their own, as ITK writes them.
#pragma once

#include <string>
#include <string_view>

#include "homolog/shape/raw_volume.h"

namespace homolog {

bool is_metaimage(std::string_view content);

/// The volume in the bytes of a MetaImage file; `file` is its name for messages. Throws FileError (truncated, malformed, not of three
/// dimensions, several channels, more voxels than allowed).
RawVolume read_metaimage(std::string_view content, const std::string& file, const ReadLimits& limits, const ReadOther& read_other);

}  // namespace homolog
