// SPDX-License-Identifier: MIT
// The truth of a folder written here, in every form that it may have, and what is refused with file and line.
#include "read_truth.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "folder.h"
#include "homolog/shape/read_mesh.h"
#include "outputs/message_of.h"

namespace homolog::bench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Closed, symmetric about x = 0: vertices 0 and 1 are each other's image. `shift` moves it along y.
std::string double_tent(double shift) {
  std::string text = "OFF\n5 6 0\n";
  for (const Vec3& v : {Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(0, 1, 3), Vec3(0, 1, -2)}) {
    text += fmt::format("{} {} {}\n", v.x(), v.y() + shift, v.z());
  }
  return text + "3 0 1 3\n3 1 2 3\n3 2 0 3\n3 1 0 4\n3 2 1 4\n3 0 2 4\n";
}

class ReadTruth : public testing::Test {
 protected:
  ReadTruth() {
    for (const int number : {0, 1, 2}) folder.write(fmt::format("s/{}.off", "abc"[number]), double_tent(10 * number));
    folder.write("parts/a__top.off", double_tent(0));
  }

  Mesh mesh(const std::string& name) const { return read_mesh(folder.path / (name + ".off")); }
  std::optional<TruePoints> read(const std::string& model, const std::string& data) {
    return reader.read({"whole", model, data, ""}, mesh(model), mesh(data));
  }
  std::string fault(const std::string& model = "s/a", const std::string& data = "s/b") {
    return message_of([&] { read(model, data); });
  }

  Folder folder;
  TruthReader reader{folder.path};
};

TEST_F(ReadTruth, FolderWithoutTruthHasNone) { EXPECT_FALSE(read("s/a", "s/b")); }

TEST_F(ReadTruth, IdentityGroupsTellVerticesAndTheirSymmetry) {
  folder.write("s/IDENTITY.corr.txt", "# vertex i <-> vertex i for every pair of: a b (5 vertices each)\r\n");
  const auto points = read("s/a", "s/b");
  ASSERT_TRUE(points);
  EXPECT_TRUE(points->dense);
  EXPECT_FALSE(points->mirrored);
  EXPECT_EQ(points->model, mesh("s/a").vertices);
  EXPECT_EQ(points->data, mesh("s/b").vertices);
  ASSERT_EQ(points->swapped_data.size(), 5u);
  EXPECT_EQ(points->swapped_data[0], mesh("s/b").vertices[1]);
  EXPECT_EQ(points->swapped_data[3], mesh("s/b").vertices[3]);
  EXPECT_FALSE(read("s/a", "s/c"));
}

TEST_F(ReadTruth, VertexPairsHoldForTheGroupOfTheData) {
  folder.write("s/IDENTITY.corr.txt", "of: a b (5 vertices each)\n");
  folder.write("parts/a__top__a.corr.txt", "# part, whole\n0 1\n1 0\n3 3\n4 4\n");
  const auto points = read("parts/a__top", "s/b");
  ASSERT_TRUE(points);
  const auto b = mesh("s/b").vertices;
  EXPECT_THAT(points->data, ElementsAre(b[1], b[0], b[3], b[4]));
  EXPECT_THAT(points->swapped_data, ElementsAre(b[0], b[1], b[3], b[4]));
}

TEST_F(ReadTruth, LandmarksGoByNameAndSwapByFileOrName) {
  folder.write("s/a.landmarks.txt", "nose 0 0 1\neye_L 1 0 0\neye_R -1 0 0\nback 0 3 1\nonly_here 9 9 9\n");
  folder.write("s/b.landmarks.txt", "eye_L 2 0 0\neye_R -2 0 0\nnose 0 0 2\r\n\r\nback 0 6 2\n");
  auto points = read("s/a", "s/b");
  ASSERT_TRUE(points);
  EXPECT_FALSE(points->dense);
  EXPECT_THAT(points->data, ElementsAre(Vec3(0, 0, 2), Vec3(2, 0, 0), Vec3(-2, 0, 0), Vec3(0, 6, 2)));
  EXPECT_THAT(points->swapped_data, ElementsAre(Vec3(0, 0, 2), Vec3(-2, 0, 0), Vec3(2, 0, 0), Vec3(0, 6, 2)));
  folder.write("s/b.symmetry.txt", "0\n1\n2 3\n");
  points = read("s/a", "s/b");
  EXPECT_THAT(points->swapped_data, ElementsAre(Vec3(0, 6, 2), Vec3(2, 0, 0), Vec3(-2, 0, 0), Vec3(0, 0, 2)));
}

TEST_F(ReadTruth, PartsInPlaceAreTheirOwnTruth) {
  folder.write("s/a__top.off", double_tent(0));
  folder.write("s/a.parts.txt", "");
  const auto points = read("s/a__top", "s/a");
  ASSERT_TRUE(points);
  EXPECT_EQ(points->data, mesh("s/a__top").vertices);
  EXPECT_EQ(points->swapped_data[3], Vec3(0, 1, -3));
}

TEST_F(ReadTruth, RefusesFaultyIdentityGroups) {
  folder.write("s/IDENTITY.corr.txt", "of: c (5 vertices each)\nof a b (5 vertices each)\n");
  EXPECT_THAT(fault(), HasSubstr("IDENTITY.corr.txt, line 2: cannot understand 'of a b"));
  folder.write("s/IDENTITY.corr.txt", "of: a b (3 vertices each)\n");
  EXPECT_THAT(fault(), HasSubstr("IDENTITY.corr.txt, line 1: fewer than four"));
  folder.write("s/IDENTITY.corr.txt", "of: a b (6 vertices each)\n");
  EXPECT_THAT(fault(), HasSubstr("IDENTITY.corr.txt, line 1: b has 5 vertices, not 6"));
  folder.write("s/IDENTITY.corr.txt", "# a remark\nof: gone a b (5 vertices each)\n");
  EXPECT_FALSE(read("s/a", "s/b")->swapped_data.empty()) << "told by those that are there";
  folder.write("s/gone.off", "OFF\nnothing\n");
  EXPECT_EQ(fault(), "") << "the symmetry is known";
  TruthReader anew(folder.path);
  for (int again = 0; again < 2; ++again) {
    EXPECT_THAT(message_of([&] { anew.read({"whole", "s/a", "s/b", ""}, mesh("s/a"), mesh("s/b")); }), HasSubstr("gone.off"));
  }
}

TEST_F(ReadTruth, RefusesFaultyVertexPairs) {
  const std::string file = "s/a__b.corr.txt", good = "0 0\n1 1\n2 2\n";
  folder.write(file, good + "3 5\n");
  EXPECT_THAT(fault(), HasSubstr("a__b.corr.txt, line 4: there is no vertex 5 among 5"));
  folder.write(file, good + "-1 3\n");
  EXPECT_THAT(fault(), HasSubstr("a__b.corr.txt, line 4: there is no vertex -1 among 5"));
  folder.write(file, good + "3 x\n");
  EXPECT_THAT(fault(), HasSubstr("a__b.corr.txt, line 4: cannot understand '3 x'"));
  folder.write(file, good);
  EXPECT_THAT(fault(), HasSubstr("ends after 3 pairs"));
  folder.write(file, "");
  EXPECT_THAT(fault(), HasSubstr("ends after 0 pairs"));
}

TEST_F(ReadTruth, RefusesFaultyLandmarks) {
  const std::string good = "p 0 0 1\nq 1 0 0\nr -1 0 0\n";
  folder.write("s/a.landmarks.txt", good);
  EXPECT_THAT(fault(), HasSubstr("a.landmarks.txt, line 4: the file ends after 3 landmarks"));
  folder.write("s/a.landmarks.txt", good + "s 0 3\n");
  EXPECT_THAT(fault(), HasSubstr("a.landmarks.txt, line 4: cannot understand 's 0 3'"));
  folder.write("s/a.landmarks.txt", good + "s 0 3 1\n");
  EXPECT_EQ(fault(), "");
  folder.write("s/b.landmarks.txt", good + "s 0 3 1\n");
  folder.write("s/b.symmetry.txt", "0 1\n2 4\n");
  EXPECT_THAT(fault(), HasSubstr("b.symmetry.txt, line 2: cannot understand '2 4'"));
}

}  // namespace
}  // namespace homolog::bench
