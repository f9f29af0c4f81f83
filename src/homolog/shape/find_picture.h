// SPDX-License-Identifier: MIT
// Pictures that files of meshes name, each read once.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "homolog/shape/attributes.h"

namespace homolog {

inline constexpr std::size_t longest_name = 100;  // of a file that is named in messages

/// The numbers in `images` of pictures by their paths as a file names them, as folders may hold pictures of one name; -1: not there.
using PictureNumbers = std::map<std::string, int>;

/// Where it is told what could not be had: AttributedMesh::missing and ::left_out.
struct PictureLosses {
  std::vector<std::string>&missing, &left_out;
};

/// What `find` finds; none, which is told, if it is not there, or outside the folder (OutsideFolder). Throws what else `find` throws.
std::optional<std::string> picture_bytes(const std::string& name, const std::function<std::optional<std::string>()>& find,
                                         PictureLosses losses);

/// The number in `images` of a picture that a file names; -1 if it cannot be had, which is told. Throws what else `find_other` throws.
int find_picture(const std::string& named, const FindOther& find_other, std::vector<Image>& images, PictureNumbers& numbers,
                 PictureLosses losses);

/// Adds the name of a file that is not there, fit for messages; once, however often it is named.
void tell_missing(const std::string& name, std::vector<std::string>& missing);

/// The name, with a number before it if one of the list has it already.
template <class Named>
std::string free_name(const std::vector<Named>& list, const std::string& name) {
  std::string free = name;
  const auto taken = [&](const Named& other) { return other.name == free; };
  for (std::size_t number = list.size(); std::any_of(list.begin(), list.end(), taken); ++number) free = fmt::format("{}_{}", number, name);
  return free;
}

}  // namespace homolog
