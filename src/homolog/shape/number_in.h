// SPDX-License-Identifier: MIT
// A number as it stands in a binary file.
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>

namespace homolog {

/// The T whose bytes stand here in the given order, as a double.
template <class T>
double number_in(const char* bytes, std::endian order) {
  char buffer[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) buffer[i] = bytes[order == std::endian::native ? i : sizeof(T) - 1 - i];
  T value;
  std::memcpy(&value, buffer, sizeof(T));
  return static_cast<double>(value);
}

}  // namespace homolog
