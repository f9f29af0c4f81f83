// SPDX-License-Identifier: MIT
#include "homolog/shape/rig.h"

#include <algorithm>

namespace homolog {

Influences strongest_influences(std::vector<Influence> influences, std::size_t most) {
  std::stable_sort(influences.begin(), influences.end(), [](const Influence& a, const Influence& b) { return a.joint < b.joint; });
  std::vector<Influence> joined;
  for (const Influence& influence : influences) {
    if (!(influence.weight > 0)) continue;
    if (joined.empty() || joined.back().joint != influence.joint) joined.push_back({influence.joint, 0});
    joined.back().weight += influence.weight;
  }
  std::stable_sort(joined.begin(), joined.end(), [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
  joined.resize(std::min({joined.size(), most, Influences{}.size()}));
  float sum = 0;
  for (const Influence& influence : joined) sum += influence.weight;
  Influences strongest{};
  for (std::size_t i = 0; i < joined.size(); ++i) strongest[i] = {joined[i].joint, joined[i].weight / sum};
  return strongest;
}

std::size_t most_influences(const std::vector<Influences>& influences) {
  for (const Influences& of_vertex : influences) {
    if (of_vertex[few_influences].weight > 0) return of_vertex.size();
  }
  return few_influences;
}

}  // namespace homolog
