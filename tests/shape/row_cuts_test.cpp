// SPDX-License-Identifier: MIT
#include "homolog/shape/row_cuts.h"

#include <gtest/gtest.h>

#include "shape/meshes.h"

namespace homolog {
namespace {

TEST(RowCuts, AreThoseOfOneRowAfterTheOther) {
  const Mesh mesh = meshes::moved(meshes::sphere(1), 3 * Mat3::Identity(), {4, 4, 4});  // some corners and sides lie on rows
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3 &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
    for (const RayAxes& axes : ray_axes) {
      for (double first = 0; first < 8; first += 1) {
        const RowCuts cuts = cut_rows(a, b, c, axes, FourDoubles{first, first + 0.25, first + 0.5, first + 0.75});
        for (int r = 0; r < 4; ++r) {
          RowCut cut;
          if (!cut_row(a, b, c, axes, first + r / 4.0, cut)) {
            EXPECT_EQ(cuts.from[r], cuts.to[r]);
            continue;
          }
          EXPECT_EQ(cuts.from[r], cut.from);
          EXPECT_EQ(cuts.to[r], cut.to);
          EXPECT_EQ(cuts.depth_from[r], cut.depth_from);
          EXPECT_EQ(cuts.depth_to[r], cut.depth_to);
          EXPECT_EQ(cuts.downward[r] != 0, cut.sign < 0);
        }
      }
    }
  }
}

}  // namespace
}  // namespace homolog
