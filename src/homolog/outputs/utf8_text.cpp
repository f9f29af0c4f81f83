// SPDX-License-Identifier: MIT
#include "homolog/outputs/utf8_text.h"

#include <nlohmann/json.hpp>

namespace homolog {
namespace {

bool is_utf8(const std::string& text) {
  try {
    nlohmann::json(text).dump();  // which is strict
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

}  // namespace

std::string utf8_text(std::string text) {
  if (is_utf8(text)) return text;
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      result += c;
    } else {
      result += static_cast<char>(0xc0 | byte >> 6);
      result += static_cast<char>(0x80 | (byte & 0x3f));
    }
  }
  return result;
}

}  // namespace homolog
