// SPDX-License-Identifier: MIT
#include "homolog/match/axis_starts.h"

#include "homolog/describe/separate_surfaces.h"
#include "homolog/match/settled_skins.h"

namespace homolog {
namespace {

constexpr std::size_t most_pieces = 12;  // of the data, that are tried apart

}  // namespace

std::vector<GrownSet> axis_starts(const Shape& model, const Shape& data, Chirality chirality, std::size_t most) {
  if (model.surface.empty() || data.surface.empty()) return {};
  std::vector<AxisSkin> skins{axis_skin(data.surface, data.diagonal)};
  for (const std::vector<int>& piece : separate_surfaces(data.surface, data.body, most_pieces)) {
    std::vector<SurfaceSample> surface;
    for (const int i : piece) surface.push_back(data.surface[i]);
    skins.push_back(axis_skin(surface, diagonal_of(surface)));
  }
  const AxisSkin laid = axis_skin(model.surface, model.diagonal);
  std::vector<GrownSet> starts;
  for (const AxisSkin& skin : skins) {
    for (const Settled& s : ways_to_lay(laid, skin, chirality, most)) starts.push_back(set_of(s.similarity, chirality));
  }
  return starts;
}

}  // namespace homolog
