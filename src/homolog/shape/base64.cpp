// SPDX-License-Identifier: MIT
#include "homolog/shape/base64.h"

#include <array>
#include <cstdint>

namespace homolog {
namespace {

constexpr std::uint8_t no_digit = 64, padding = 65, blank = 66;

constexpr std::array<std::uint8_t, 256> digits() {
  std::array<std::uint8_t, 256> values{};
  values.fill(no_digit);
  std::uint8_t next = 0;
  for (const char c : std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")) {
    values[static_cast<unsigned char>(c)] = next++;
  }
  values['='] = padding;
  for (const char c : {' ', '\t', '\r', '\n'}) values[static_cast<unsigned char>(c)] = blank;
  return values;
}

constexpr std::array<std::uint8_t, 256> digit_of = digits();

}  // namespace

bool decode_base64(std::string_view& text, std::size_t wanted, std::string& bytes) {
  std::uint32_t bits = 0;
  int count = 0;
  std::size_t used = 0;
  while (used < text.size() && (bytes.size() < wanted || count > 0)) {
    const std::uint8_t digit = digit_of[static_cast<unsigned char>(text[used])];
    if (digit == no_digit) return false;
    ++used;
    if (digit == blank) continue;
    if (digit == padding) {
      count = 0;  // what is left over of the group are zeros
      continue;
    }
    bits = bits << 6 | digit;
    if ((count += 6) < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  text.remove_prefix(used);
  return true;
}

}  // namespace homolog
