// SPDX-License-Identifier: MIT
// Volume files through read_mesh(): the fixture that knows where their label lies.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "homolog/shape/label_surface.h"
#include "homolog/shape/orient.h"
#include "shape/files.h"
#include "shape/meshes.h"
#include "shape/volume_files.h"

namespace homolog {

class VolumeTest : public FileTest {
 protected:
  /// The box of ones in LPS: half a voxel beyond the middles of its outer voxels, but for what smoothing does to so small a box.
  static void expect_box_of_ones(const Mesh& mesh) {
    const Box box = bounding_box(mesh);
    const Vec3 spacing(2, 3, 4), low(-10 - 2 * 3.5, -20 - 3 * 4.5, 30 + 4 * 0.5), high(-10 - 2 * 0.5, -20 - 3 * 0.5, 30 + 4 * 3.5);
    EXPECT_LT((box.min - low).cwiseQuotient(spacing).cwiseAbs().maxCoeff(), 0.2) << box.min.transpose();
    EXPECT_LT((box.max - high).cwiseQuotient(spacing).cwiseAbs().maxCoeff(), 0.2) << box.max.transpose();
    EXPECT_TRUE(orient(mesh).closed());
    EXPECT_GT(meshes::volume(mesh), 0.5 * (6 * 12 * 12));
  }
};

/// A header with a part put in the place of another one.
inline std::string with(std::string content, const std::string& part, const std::string& other) {
  return content.replace(content.find(part), part.size(), other);
}

}  // namespace homolog
