// SPDX-License-Identifier: MIT
#include "homolog/shape/voxelize.h"

#include <gmock/gmock.h>

#include <limits>

#include "fixtures/solids.h"
#include "homolog/base/errors.h"
#include "homolog/base/parallel.h"
#include "shape/meshes.h"

namespace homolog {
namespace {

using meshes::volume;

double volume_of_voxels(const Mesh& mesh, int resolution) { return volume(voxelize(mesh, resolution).interior); }

float largest_difference(const Interior& a, const Interior& b) {
  EXPECT_EQ(a.frame.size, b.frame.size);
  float largest = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) largest = std::max(largest, std::abs(a.values[i] - b.values[i]));
  return largest;
}

TEST(Voxelize, FrameIsTightWithAMargin) {
  const GridFrame frame = voxelize(meshes::box({1, 2, 3}, {5, 4, 4}), 40).interior.frame;
  EXPECT_EQ(frame.size, (std::array<int, 3>{42, 22, 12}));
  EXPECT_DOUBLE_EQ(frame.spacing, 0.1);
  EXPECT_TRUE(frame.origin.isApprox(Vec3(0.95, 1.95, 2.95), 1e-12));
}

TEST(Voxelize, BoxOnGridPlanesIsExact) {
  const Interior interior = voxelize(meshes::box({1, 2, 3}, {5, 4, 4}), 40).interior;
  const auto& n = interior.frame.size;
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        const bool margin = i == 0 || j == 0 || k == 0 || i == n[0] - 1 || j == n[1] - 1 || k == n[2] - 1;
        ASSERT_EQ(interior.at(i, j, k), margin ? 0.f : 1.f) << i << " " << j << " " << k;
      }
    }
  }
}

TEST(Voxelize, VolumesAreThoseOfTheFormulas) {
  EXPECT_NEAR(volume_of_voxels(meshes::sphere(6), 96) / (4 * M_PI / 3), 1, 1e-3);
  EXPECT_NEAR(volume_of_voxels(meshes::torus(1, 0.4, 200, 100), 96) / (2 * M_PI * M_PI * 0.16), 1, 2e-3);
  for (const Mesh& mesh : {meshes::sphere(2), meshes::torus(1, 0.2, 30, 9), fixtures::mesh_of(fixtures::hand(), 48)}) {
    EXPECT_NEAR(volume_of_voxels(mesh, 64) / volume(mesh), 1, 1e-3);
  }
}

TEST(Voxelize, VolumeDoesNotChangeWhenTurned) {
  const Mesh solids[] = {meshes::box({0, 0, 0}, {1, 1, 1}), meshes::sphere(3), meshes::torus(1, 0.2, 60, 30),
                         meshes::box({0, 0, 0}, {1, 1, 0.04})};
  for (const Mesh& mesh : solids) {
    for (std::uint32_t seed = 0; seed < 25; ++seed) {
      const Voxels voxels = voxelize(meshes::moved(mesh, fixtures::random_rotation(seed), {3, 1, 2}), 64);
      EXPECT_NEAR(volume(voxels.interior) / volume(mesh), 1, 1e-3) << seed;
      EXPECT_EQ(voxels.guessed, 0);
    }
  }
}

TEST(Voxelize, BoxOfAnySidesIsExact) {  // rays stand in the middle of what the bounding box leaves of their cells
  for (const Vec3& sides : {Vec3(1, 0.345, 0.0123), Vec3(0.77, 1, 1e-3)}) {
    EXPECT_NEAR(volume_of_voxels(meshes::box(Vec3::Ones(), Vec3::Ones() + sides), 64) / sides.prod(), 1, 1e-3);
  }
}

TEST(Voxelize, NothingLeaks) {  // no voxel outside the solid's neighbourhood gets anything, none deep inside misses anything
  for (std::uint32_t seed = 0; seed < 25; ++seed) {
    const Mat3 turn = seed == 0 ? Mat3::Identity() : fixtures::random_rotation(seed);
    const Interior interior = voxelize(meshes::moved(meshes::box({-1, -1, -1}, {1, 1, 1}), turn), 48).interior;
    const double reach = interior.frame.spacing * std::sqrt(3) / 2;
    for (int k = 0; k < interior.frame.size[2]; ++k) {
      for (int j = 0; j < interior.frame.size[1]; ++j) {
        for (int i = 0; i < interior.frame.size[0]; ++i) {
          const double beyond = (turn.transpose() * interior.frame.world_from_voxel({i + 0., j + 0., k + 0.})).cwiseAbs().maxCoeff() - 1;
          if (std::abs(beyond) > reach) {
            ASSERT_EQ(interior.at(i, j, k), beyond < 0 ? 1.f : 0.f);
          }
        }
      }
    }
  }
}

TEST(Voxelize, TriangulationDoesNotMatter) {  // the same box with every face cut into slivers whose corners lie on rays
  Mesh fine = meshes::box({0, 0, 0}, {1, 1, 1});
  for (int round = 0; round < 3; ++round) {
    Mesh next{fine.vertices, {}};
    for (const auto& [a, b, c] : fine.triangles) {
      const auto n = static_cast<std::uint32_t>(next.vertices.size());
      next.vertices.push_back((fine.vertices[a] + 2 * fine.vertices[b] + fine.vertices[c]) / 4);
      next.triangles.insert(next.triangles.end(), {{a, b, n}, {b, c, n}, {c, a, n}});
    }
    fine = next;
  }
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    const Mat3 turn = seed == 0 ? Mat3::Identity() : fixtures::random_rotation(seed);
    const Interior coarse = voxelize(meshes::moved(meshes::box({0, 0, 0}, {1, 1, 1}), turn), 32).interior;
    EXPECT_LT(largest_difference(coarse, voxelize(meshes::moved(fine, turn), 32).interior), 1e-4);
  }
}

TEST(Voxelize, ScaleAndShiftDoNotMatter) {
  const Mesh mesh = meshes::moved(fixtures::mesh_of(fixtures::hand(), 40), fixtures::random_rotation(4));
  const Interior interior = voxelize(mesh, 64).interior;
  for (const double scale : {1e-6, 1e6, 1e-100}) {
    EXPECT_LT(largest_difference(interior, voxelize(meshes::moved(mesh, scale * Mat3::Identity(), scale * Vec3(50, -20, 7)), 64).interior),
              1e-2);
  }
}

TEST(Voxelize, OverlappingShellsAreAUnion) {
  const Mesh a = meshes::box({0, 0, 0}, {2, 2, 2}), b = meshes::box({1, 1, 1}, {3, 3, 3});
  for (const Mesh& second : {b, meshes::reversed(b)}) {
    for (std::uint32_t seed = 0; seed < 5; ++seed) {
      const Voxels voxels = voxelize(meshes::moved(meshes::joined(a, second), fixtures::random_rotation(seed)), 64);
      EXPECT_NEAR(volume(voxels.interior), 8 + 8 - 1, 15e-3);
      EXPECT_EQ(voxels.guessed, 0);
    }
  }
}

TEST(Voxelize, ReversedShellsInsideAreCavities) {
  const Mesh hollow = meshes::joined(meshes::sphere(4), meshes::reversed(meshes::moved(meshes::sphere(4), Mat3::Identity() * 0.5)));
  EXPECT_NEAR(volume_of_voxels(hollow, 64) / volume(hollow), 1, 1e-3);
  EXPECT_EQ(sample(voxelize(hollow, 64).interior, Vec3::Zero()), 0);
  EXPECT_NEAR(volume_of_voxels(meshes::reversed(hollow), 64) / volume(hollow), 1, 1e-3);
}

TEST(Voxelize, ClosesAnOpenBoxAndSaysSo) {
  Mesh open = meshes::box({0, 0, 0}, {1, 1, 1});
  open.triangles.resize(10);
  const Voxels voxels = voxelize(open, 32);
  EXPECT_NEAR(volume(voxels.interior), 1, 1e-6);
  EXPECT_GT(voxels.guessed, 0.9);
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    const Voxels turned = voxelize(meshes::moved(open, fixtures::random_rotation(seed)), 64);
    EXPECT_GT(volume(turned.interior), 0.5);
    EXPECT_LT(volume(turned.interior), 1.05);
    EXPECT_GT(turned.guessed, 0);
  }
}

TEST(Voxelize, MissingTrianglesAreMended) {
  Mesh torus = meshes::torus(1, 0.4, 60, 30);
  const double whole = volume_of_voxels(torus, 64);
  for (std::size_t i = 0; i < 20; ++i) torus.triangles.erase(torus.triangles.begin() + static_cast<std::ptrdiff_t>(i * 170));
  const Voxels voxels = voxelize(torus, 64);
  EXPECT_NEAR(volume(voxels.interior) / whole, 1, 1e-3);
  EXPECT_GT(voxels.guessed, 0);
  EXPECT_LT(voxels.guessed, 0.2);
}

TEST(Voxelize, PartIsCutExactly) {
  const Mesh box = meshes::box({0, 0, 0}, {2, 1, 1});
  const Voxels voxels = voxelize(box, 50, Box{{0.1, 0.2, 0.3}, {0.83, 0.6, 1}});
  EXPECT_NEAR(volume(voxels.interior), 1.46 * 0.4 * 0.7, 1e-5);
  EXPECT_NEAR(voxels.interior.frame.spacing, 1.46 / 50, 1e-12);
  EXPECT_EQ(voxels.interior.frame.size[0], 52);
}

TEST(Voxelize, PartsAddUpToTheWhole) {
  const Mesh mesh = meshes::moved(fixtures::mesh_of(fixtures::quadruped(), 48), fixtures::random_rotation(2));
  double sum = 0;
  for (const auto& [from, to] : {std::pair{0., 0.31}, {0.31, 0.7}, {0.7, 1.}}) {
    sum += volume(voxelize(mesh, 64, Box{{0, from, 0}, {1, to, 1}}).interior);
  }
  EXPECT_NEAR(sum / volume(mesh), 1, 1e-3);
}

TEST(Voxelize, PartHasItsFullResolution) {
  const Mesh pair = meshes::joined(meshes::sphere(4), meshes::moved(meshes::sphere(4), Mat3::Identity() * 0.25, {9.75, 0, 0}));
  const Interior interior = voxelize(pair, 40, Box{{0.5, 0, 0}, {1, 1, 1}}).interior;
  EXPECT_EQ(interior.frame.size, (std::array<int, 3>{42, 42, 42}));
  EXPECT_NEAR(interior.frame.spacing, 0.5 / 40, 1e-12);
  EXPECT_THROW(voxelize(pair, 40, Box{{0.3, 0, 0}, {0.4, 1, 1}}), ShapeError);
}

TEST(Voxelize, ShapesWithoutInsideAreErrors) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(voxelize(Mesh{}, 32), ShapeError);
  EXPECT_THROW(voxelize(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 32), ShapeError);
  EXPECT_THROW(voxelize(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}, 32), ShapeError);
  EXPECT_THROW(voxelize(Mesh{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}}, 32), ShapeError);
  EXPECT_THROW(voxelize(Mesh{{{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 32), ShapeError);
  EXPECT_THROW(voxelize(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}}, 32), ShapeError);
  EXPECT_THROW(voxelize(meshes::moved(meshes::sphere(1), Mat3::Identity() * 1.5e308), 32), ShapeError);
  EXPECT_THROW(voxelize(meshes::sphere(1), 0), ParamError);
  EXPECT_THROW(voxelize(meshes::sphere(1), 32, Box{{0, 0, 0}, {1, 0, 1}}), ParamError);
  EXPECT_THROW(voxelize(meshes::sphere(1), 32, Box{{0, 0, 0}, {1, 1, 1.5}}), ParamError);
}

/// Triangles between random places of a box.
Mesh random_triangles(std::uint32_t count) {
  Mesh mesh;
  std::uint64_t state = 1;
  const auto next = [&] { return static_cast<double>((state = state * 6364136223846793005u + 1442695040888963407u) >> 33) / 2147483648.0; };
  for (std::uint32_t i = 0; i < 3 * count; ++i) mesh.vertices.emplace_back(next(), next(), next());
  for (std::uint32_t i = 0; i < count; ++i) mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  return mesh;
}

TEST(Voxelize, RefusesWhatWouldTakeForEver) {
  const auto message = [](std::uint32_t triangles, int resolution) {
    try {
      voxelize(random_triangles(triangles), resolution);
    } catch (const ShapeError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message(100000, 64), testing::HasSubstr("deep through its box in the mean"));
  EXPECT_THAT(message(2000, 96), testing::HasSubstr("so loosely through each other"));
  EXPECT_EQ(message(200, 32).find("take"), std::string::npos) << "few are asked";
}

TEST(Voxelize, DoesNotDependOnThreads) {
  Mesh mesh = meshes::moved(fixtures::mesh_of(fixtures::hand(), 40), fixtures::random_rotation(4));
  for (int round = 0; round < 2; ++round) {
    const std::vector<float> many = voxelize(mesh, 64).interior.values;
    const ThreadLimit one(1);
    EXPECT_EQ(voxelize(mesh, 64).interior.values, many);
    mesh.triangles.pop_back();  // and once more with a hole
  }
}

}  // namespace
}  // namespace homolog
