// SPDX-License-Identifier: MIT
// A limb that points elsewhere in the data is known by where it branches off.
#include "homolog/match/turned_limbs.h"

#include <gtest/gtest.h>

#include "fixtures/laid.h"

namespace homolog {
namespace {

using namespace fixtures;

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

}  // namespace
}  // namespace homolog
