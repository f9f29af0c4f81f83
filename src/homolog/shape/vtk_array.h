// SPDX-License-Identifier: MIT
// Arrays of numbers in the XML files of VTK: as text, as base64, or among raw bytes at the end of the file, compressed or not.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "homolog/shape/number_type.h"

namespace homolog {

/// How all arrays of a file lie in it.
struct VtkStorage {
  std::string file;  ///< its name for messages
  std::endian order = std::endian::little;
  NumberType sizes = NumberType::uint32;  ///< of the numbers of bytes that stand before arrays
  std::string compressor = {};            ///< what compressed them; empty: nothing
  std::string_view appended = {};         ///< the bytes of all arrays that are not where they are named
  bool appended_base64 = false;
};

struct VtkArray {
  NumberType type;
  std::string_view text;                        ///< between its tags
  bool binary = false;                          ///< that text is base64
  std::optional<std::size_t> appended_at = {};  ///< where it begins among the appended bytes
};

/// The first text of an array of texts. Throws FileError, also for more than a kB.
std::string first_text_of(const VtkArray& array, const VtkStorage& storage);

/// The `count` numbers that an array must have. Memory is taken as they come, whatever is announced. Throws FileError.
std::vector<double> numbers_of(const VtkArray& array, std::size_t count, const VtkStorage& storage);

}  // namespace homolog
