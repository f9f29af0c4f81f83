// SPDX-License-Identifier: MIT
// A limb that points elsewhere in the data is known by where it branches off, and laid along the data's.
#include "homolog/match/turned_limbs.h"

#include <gtest/gtest.h>

#include "fixtures/laid.h"
#include "homolog/match/draw_onto.h"

namespace homolog {
namespace {

using namespace fixtures;

// The end of a body nearest to a place.
int end_at(const Shape& shape, const Vec3& place) {
  const auto away = [&](int node) { return (shape.body.nodes[node] - place).norm(); };
  int found = 0;
  for (std::size_t k = 0; k < shape.ends.nodes.size(); ++k) {
    if (away(shape.ends.nodes[k]) < away(shape.ends.nodes[found])) found = static_cast<int>(k);
  }
  return found;
}

TEST(TurnedLimbs, AreKnownByWhereTheyBranchOff) {
  const Vec3 here(1.1, 0, 0), there(0, 0.1, -1.4);
  const Shape model = star(here), data = star(there);
  const EndsTogether together = ends_together(laid(model), model, data);
  ASSERT_EQ(together.model.size(), 3u);
  const EndsTogether turned = turned_ends(together, laid(model), model, data);
  ASSERT_EQ(turned.model.size(), 1u);
  EXPECT_EQ(turned.model[0], end_at(model, here));
  EXPECT_EQ(turned.data[0], end_at(data, there));
}

TEST(TurnedLimbs, AreNotSoughtWithoutEndsTogether) {
  const Shape model = star({1.1, 0, 0});
  EXPECT_TRUE(turned_ends({}, laid(model), model, model).model.empty());
}

TEST(TurnedLimbs, AreLaidAlongTheDatasAndStay) {
  const Vec3 here(1.1, 0, 0), there(0, 0.1, -1.4);
  const Shape model = star(here), data = star(there);
  Cloth cloth = laid(model);
  const EndsTogether together = ends_together(cloth, model, data);
  const EndsTogether all = joined(together, turned_ends(together, cloth, model, data));
  lay_limbs(cloth, all, together.model.size(), model, data);
  const int tip = model.ends.nodes[end_at(model, here)], other = model.ends.nodes[end_at(model, {0, 1.2, 0.1})];
  const Vec3 data_tip = data.body.nodes[data.ends.nodes[end_at(data, there)]];
  EXPECT_LT((cloth.nodes[tip] - data_tip).norm(), 0.1);
  EXPECT_EQ(cloth.nodes[other], model.body.nodes[other]);
  draw_onto(cloth, model, data, {}, {14, 0.03, 0.008, 0.7, 0.1}, 1200, all);
  EXPECT_LT((cloth.nodes[tip] - data_tip).norm(), 0.1);
}

}  // namespace
}  // namespace homolog
