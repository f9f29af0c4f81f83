// SPDX-License-Identifier: MIT
// Colours as screens show them (sRGB, IEC 61966-2-1), of PLY, OBJ and pictures, and as light adds up (linear), of glTF's numbers.
#pragma once

#include <algorithm>
#include <cmath>

#include "homolog/shape/texturing.h"

namespace homolog {

inline float srgb_of_linear(float x) {
  x = std::clamp(x, 0.0f, 1.0f);
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

inline float linear_of_srgb(float x) {
  x = std::clamp(x, 0.0f, 1.0f);
  return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

/// Alpha is a share and stays.
inline Rgba srgb_of_linear(const Rgba& c) { return {srgb_of_linear(c[0]), srgb_of_linear(c[1]), srgb_of_linear(c[2]), c[3]}; }
inline Rgba linear_of_srgb(const Rgba& c) { return {linear_of_srgb(c[0]), linear_of_srgb(c[1]), linear_of_srgb(c[2]), c[3]}; }

}  // namespace homolog
