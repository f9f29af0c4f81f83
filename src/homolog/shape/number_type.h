// SPDX-License-Identifier: MIT
// Numbers as they stand in binary files.
#pragma once

#include <bit>
#include <cstddef>

namespace homolog {

enum class NumberType { none, int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// Bytes of a number; 0 for none.
std::size_t bytes_of(NumberType type);

/// The number whose bytes stand here in the given order, as a double.
double stored_number(const char* bytes, NumberType type, std::endian order);

}  // namespace homolog
