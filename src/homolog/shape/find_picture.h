// SPDX-License-Identifier: MIT
// Pictures that files of meshes name, each read once.
#pragma once

#include <string>
#include <vector>

#include "homolog/shape/attributes.h"

namespace homolog {

inline constexpr std::size_t longest_name = 100;  // of a file that is named in messages

/// The number in `images` of a picture that a file names; -1 if it is not there, which then stands in `missing`. Throws what `find_other`
/// throws.
int find_picture(const std::string& named, const FindOther& find_other, std::vector<Image>& images, std::vector<std::string>& missing);

/// Adds the name of a file that is not there, fit for messages; once, however often it is named.
void tell_missing(const std::string& name, std::vector<std::string>& missing);

}  // namespace homolog
