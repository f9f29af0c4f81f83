// SPDX-License-Identifier: MIT
#include "homolog/shape/number_type.h"

#include <array>
#include <cstdint>
#include <cstring>

namespace homolog {
namespace {

template <class T>
double number_in(const char* bytes, std::endian order) {
  char buffer[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) buffer[i] = bytes[order == std::endian::native ? i : sizeof(T) - 1 - i];
  T value;
  std::memcpy(&value, buffer, sizeof(T));
  return static_cast<double>(value);
}

}  // namespace

std::size_t bytes_of(NumberType type) {
  static constexpr std::array<std::size_t, 11> bytes{0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return bytes[static_cast<std::size_t>(type)];
}

double stored_number(const char* bytes, NumberType type, std::endian order) {
  switch (type) {
    case NumberType::none:
      return 0;
    case NumberType::int8:
      return number_in<std::int8_t>(bytes, order);
    case NumberType::uint8:
      return number_in<std::uint8_t>(bytes, order);
    case NumberType::int16:
      return number_in<std::int16_t>(bytes, order);
    case NumberType::uint16:
      return number_in<std::uint16_t>(bytes, order);
    case NumberType::int32:
      return number_in<std::int32_t>(bytes, order);
    case NumberType::uint32:
      return number_in<std::uint32_t>(bytes, order);
    case NumberType::int64:
      return number_in<std::int64_t>(bytes, order);
    case NumberType::uint64:
      return number_in<std::uint64_t>(bytes, order);
    case NumberType::float32:
      return number_in<float>(bytes, order);
    case NumberType::float64:
      break;
  }
  return number_in<double>(bytes, order);
}

}  // namespace homolog
