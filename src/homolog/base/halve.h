// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

namespace homolog {

/// Reorders the numbers [first, last) of places so that those before `cut` lie before the others along the longest side of their box;
/// equal coordinates by number, so that the halves do not depend on the order before.
template <class Place, class It>
void halve(It first, It cut, It last, const std::vector<Place>& places) {
  Place low = places[*first], high = low;
  for (It it = first; it != last; ++it) low = low.cwiseMin(places[*it]), high = high.cwiseMax(places[*it]);
  int axis = 0;
  (high - low).maxCoeff(&axis);
  std::nth_element(first, cut, last,
                   [&](auto a, auto b) { return places[a][axis] != places[b][axis] ? places[a][axis] < places[b][axis] : a < b; });
}

}  // namespace homolog
