// SPDX-License-Identifier: MIT
// A limb laid along the data's comes to its tip, whether it points elsewhere or is of another length, and stays there when drawn on.
#include "homolog/match/laid_limbs.h"

#include <gtest/gtest.h>

#include "fixtures/laid.h"
#include "homolog/match/draw_onto.h"
#include "homolog/match/turned_limbs.h"

namespace homolog {
namespace {

using namespace fixtures;

constexpr ClothSchedule last{14, 0.03, 0.008, 0.7, 0.1};
const Vec3 short_tip(1, 0, 0), long_tip(1.6, 0, 0), other_tip(0, 1.2, 0.1);

double tip_missed(const Cloth& cloth, const Shape& model, const Vec3& tip, const Shape& data, const Vec3& data_tip) {
  return (cloth.nodes[model.ends.nodes[end_at(model, tip)]] - data.body.nodes[data.ends.nodes[end_at(data, data_tip)]]).norm();
}

TEST(LaidLimbs, AreThoseWhoseEndsAreApart) {
  const Shape model = star(short_tip), data = star(long_tip);
  Cloth cloth = laid(model);
  ASSERT_EQ(ends_together(cloth, model, data).model.size(), 4u);
  const std::vector<Anchor> tips = lay_limbs_of_other_length(cloth, model, data);
  ASSERT_EQ(tips.size(), 1u);
  EXPECT_EQ(static_cast<int>(tips[0].node), model.ends.nodes[end_at(model, short_tip)]);
  EXPECT_EQ(tips[0].place, data.body.nodes[data.ends.nodes[end_at(data, long_tip)]]);
  Cloth same = laid(model);
  EXPECT_TRUE(lay_limbs_of_other_length(same, model, model).empty());
  EXPECT_EQ(same.nodes, model.body.nodes);
}

TEST(LaidLimbs, AreStretchedAlongThemselvesAlone) {
  const Shape model = star(short_tip), data = star(long_tip);
  Cloth cloth = laid(model);
  lay_limbs_of_other_length(cloth, model, data);
  Mat3 mean = Mat3::Zero();
  double count = 0;
  for (std::size_t i = 0; i < cloth.nodes.size(); ++i) {
    const Vec3& node = model.body.nodes[i];
    if (node.x() > 0.6) {  // the limb reaches to 1.12, the data's to 1.72, and both branch off near 0.2
      mean += cloth.rest[i], ++count;
      EXPECT_NEAR(cloth.nodes[i].tail<2>().norm(), node.tail<2>().norm(), 0.08);
    } else if (node.x() < -0.4) {
      EXPECT_EQ(cloth.nodes[i], node);
      EXPECT_EQ(cloth.rest[i], Mat3::Identity());
    }
  }
  mean /= count;
  EXPECT_NEAR(mean(0, 0), 1.6, 0.2);
  EXPECT_NEAR(mean(1, 1), 1, 0.05);
  EXPECT_NEAR(mean(2, 2), 1, 0.05);
}

TEST(LaidLimbs, KeepTheirLengthWhenDrawnOn) {
  for (const auto& [here, there] : {std::pair(short_tip, long_tip), std::pair(long_tip, short_tip)}) {
    const Shape model = star(here), data = star(there);
    Cloth plain = laid(model), full = plain;
    const std::vector<Anchor> tips = lay_limbs_of_other_length(full, model, data);
    ASSERT_FALSE(tips.empty());
    draw_onto(full, model, data, tips, last, 1200);
    draw_onto(plain, model, data, {}, last, 1200);
    EXPECT_LT(tip_missed(full, model, here, data, there), 0.02 * data.diagonal);
    EXPECT_LT(tip_missed(full, model, here, data, there), 0.5 * tip_missed(plain, model, here, data, there));
  }
}

TEST(LaidLimbs, FollowThoseThatPointElsewhere) {
  const Vec3 here(1.1, 0, 0), there(0, 0.1, -1.4);
  const Shape model = star(here), data = star(there);
  Cloth cloth = laid(model);
  const EndsTogether together = ends_together(cloth, model, data);
  const EndsTogether all = joined(together, turned_ends(together, cloth, model, data));
  ASSERT_EQ(all.model.size(), together.model.size() + 1);
  lay_limbs(cloth, all, {together.model.size()}, model, data);
  const int other = model.ends.nodes[end_at(model, other_tip)];
  EXPECT_EQ(cloth.nodes[other], model.body.nodes[other]);
  EXPECT_LT(tip_missed(cloth, model, here, data, there), 0.1);
  draw_onto(cloth, model, data, {}, last, 1200, all);
  EXPECT_LT(tip_missed(cloth, model, here, data, there), 0.1);
}

}  // namespace
}  // namespace homolog
