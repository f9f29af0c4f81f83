// SPDX-License-Identifier: MIT
#include "homolog/shape/nested_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace homolog {
namespace {

TEST(NestedBoxes, FindsAllThatHoldAPlaceAndFewOthers) {
  std::mt19937 dice(1);
  const auto share = [&] { return static_cast<double>(dice()) / 4294967296.0; };
  std::vector<Box> boxes;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 low(share() - 0.5, share() - 0.5, share() - 0.5);
    boxes.push_back({low, low + std::pow(10.0, -1 - 2 * share()) * Vec3(share(), share(), 1)});
  }
  boxes.push_back({Vec3::Constant(-1), Vec3::Constant(1)});
  const NestedBoxes nested(boxes);
  std::size_t others = 0;
  for (int n = 0; n < 300; ++n) {
    const Vec3 place(share() - 0.5, share() - 0.5, share() - 0.5);
    const std::vector<std::uint32_t> found = nested.around(place);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      const bool holds = (place.array() >= boxes[i].min.array()).all() && (place.array() <= boxes[i].max.array()).all();
      const bool is_found = std::binary_search(found.begin(), found.end(), i);
      EXPECT_TRUE(is_found || !holds);
      others += is_found && !holds;
    }
  }
  EXPECT_LT(others, 300u * 300u);
}

TEST(NestedBoxes, TakesBoxesOfAnySize) {
  const std::vector<Box> boxes{
      {Vec3::Constant(-1e300), Vec3::Constant(1e300)}, {Vec3::Zero(), Vec3::Zero()}, {Vec3::Zero(), Vec3::Constant(1e-300)}};
  EXPECT_EQ(NestedBoxes(boxes).around(Vec3::Zero()), (std::vector<std::uint32_t>{0, 1, 2}));
}

}  // namespace
}  // namespace homolog
