// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace homolog {

/// The first `most` elements that differ from all kept before them, in the same order. `same(candidate, kept)` tells whether two do not.
template <class T, class Same>
std::vector<T> distinct(std::vector<T> all, std::size_t most, const Same& same) {
  std::vector<T> kept;
  for (T& candidate : all) {
    if (kept.size() == most) break;
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const T& other) { return same(candidate, other); });
    if (!known) kept.push_back(std::move(candidate));
  }
  return kept;
}

}  // namespace homolog
