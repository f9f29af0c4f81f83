// SPDX-License-Identifier: MIT
#include "homolog/outputs/read_match.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "homolog/base/errors.h"
#include "homolog/base/read_file.h"
#include "homolog/outputs/match_json.h"
#include "homolog/outputs/parts.h"
#include "homolog/outputs/symmetry_text.h"
#include "homolog/outputs/write_file.h"
#include "outputs/match_fixture.h"
#include "outputs/message_of.h"

namespace homolog {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct ReadFamily : testing::Test {
  fs::path folder =
      fs::path(testing::TempDir()) / ("read_match_test_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  Shape model = fixtures::shape("model.off", 1), data = fixtures::shape("data.off", 2);
  Family family = fixtures::family(model, data);
  Mesh mesh{{{0, 0, 0}}, {}};

  void SetUp() override {
    fs::create_directories(folder);
    model.surface = {{{0.1, 0.2, 0.3}, Vec3::UnitX()}, {{1, 2, 3}, Vec3::UnitX()}};
    write_file(folder / "match.json", match_json(model, data, family, {}));
  }
  void TearDown() override { fs::remove_all(folder); }

  void write_parts(int matches) {
    const MatchParts part{{{1}, {1, 0.25f}, Box{{0, 0, 0}, {0.5, 2, 3}}}, {{0}, {}, {}}};
    write_file(folder / "parts.json", text_of([&](const Sink& sink) {
                 write_parts_json({mesh, model}, {mesh, data}, std::vector<MatchParts>(matches, part), sink);
               }));
  }
  void write_changed_parts(const std::string& from, const std::string& to) {
    write_parts(1);
    std::string parts = read_file(folder / "parts.json");
    parts.replace(parts.find(from), from.size(), to);
    write_file(folder / "parts.json", parts);
  }
  std::string message() const {
    try {
      read_family(folder / "match.json");
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(ReadFamily, ReadsBackWhatMatchJsonWrites) {
  const StoredFamily stored = read_family(folder / "match.json");
  EXPECT_EQ(stored.model.file, "model.off");
  EXPECT_EQ(stored.data.file, "data.off");
  EXPECT_FALSE(stored.parts_known);
  ASSERT_EQ(stored.matches.size(), 1u);
  const MatchMap& match = stored.matches[0];
  const ThinPlateSpline& warp = family.matches[0].data_from_model;
  EXPECT_EQ(match.data_from_model.kernel, warp.kernel);
  EXPECT_EQ(match.data_from_model.centres, warp.centres);
  EXPECT_EQ(match.data_from_model.weights, warp.weights);
  EXPECT_EQ(match.data_from_model.affine, warp.affine);
  EXPECT_EQ(match.scale, 2);
  ASSERT_EQ(match.known.size(), 2u);
  EXPECT_EQ(match.known[1].position, model.points[2].position);
  EXPECT_EQ(match.known[1].confidence, family.matches[0].pairs[1].confidence);
  EXPECT_EQ(match.model_diagonal, 10);
  EXPECT_EQ(match.data_diagonal, 20);
}

TEST_F(ReadFamily, ReadsThePartsBesideIt) {
  write_parts(1);
  const StoredFamily stored = read_family(folder / "match.json");
  EXPECT_TRUE(stored.parts_known);
  EXPECT_EQ(stored.matches[0].model.positions, (std::vector<Vec3>{{0.1, 0.2, 0.3}, {1, 2, 3}}));
  EXPECT_EQ(stored.matches[0].model.weights, (std::vector<float>{1, 0.25f}));
  EXPECT_EQ(stored.matches[0].model.box.value().max, Vec3(0.5, 2, 3));
  EXPECT_FALSE(stored.matches[0].data.box);
  EXPECT_EQ(stored.matches[0].confidence, family.matches[0].confidence);
  EXPECT_TRUE(stored.matches[0].data.positions.empty());
}

TEST_F(ReadFamily, RefusesPartsOfAnotherMatch) {
  write_parts(2);
  EXPECT_THAT(message(), HasSubstr("parts.json: it belongs to another match.json"));
}

TEST_F(ReadFamily, RefusalsHoldNoCommandsForTheTerminal) {
  write_file(folder / "match.json", "\"\x7f");
  EXPECT_THAT(message(), HasSubstr("it stops being JSON in line 1, at '\"?'"));
}

TEST_F(ReadFamily, RefusesListsInListsDeeperThanTheStack) {
  const std::size_t depth = 1000000;
  write_file(folder / "match.json", "{\"format\": " + std::string(depth, '[') + std::string(depth, ']') + "}");
  EXPECT_THAT(message(), HasSubstr("its format is array"));
}

TEST_F(ReadFamily, SaysWhatIsWrong) {
  write_file(folder / "match.json", points_json(model, {}));
  EXPECT_THAT(message(), HasSubstr("its format is \"homolog-points\", not \"homolog-match\""));
  write_file(folder / "match.json", "{\"format\": \"homolog-match\", \"version\": 2}");
  EXPECT_THAT(message(), HasSubstr("its version is 2, but only 1 is known"));
  write_file(folder / "match.json", "{\"format\": \"homolog-match\", \"version\": 1}");
  EXPECT_THAT(message(), HasSubstr("this is not a file of matches (key 'model' not found)"));
  family.matches[0].confidence = 7;
  write_file(folder / "match.json", match_json(model, data, family, {}));
  EXPECT_THAT(message(), HasSubstr("the confidence of a match is not from 0 to 1"));
  family.matches[0].confidence = 1;
  family.matches[0].pairs[0].confidence = -1;
  write_file(folder / "match.json", match_json(model, data, family, {}));
  EXPECT_THAT(message(), HasSubstr("the confidence of a pair is not from 0 to 1"));
  family.matches[0].pairs[0].model = 3;
  write_file(folder / "match.json", match_json(model, data, family, {}));
  EXPECT_THAT(message(), HasSubstr("this is not a file of matches"));
  write_file(folder / "match.json", match_json(model, data, family, {}).substr(0, 500));
  EXPECT_THAT(message(), HasSubstr("match.json: this is not a file of matches"));
}

TEST_F(ReadFamily, RefusesWarpsThatCannotBe) {
  const auto refuses = [&](const std::string& what) {
    const std::string text = match_json(model, data, family, {});
    EXPECT_THAT(message_of([&] { read_family({text, "match.json"}, std::nullopt); }), HasSubstr("match.json: " + what));
    EXPECT_THAT(message_of([&] { read_result({text, "match.json"}, std::nullopt); }), HasSubstr("match.json: " + what));
  };
  ThinPlateSpline& warp = family.matches[0].data_from_model;
  const ThinPlateSpline sound = warp;
  for (const double weight : {1e5, 1e300, 1e308}) {
    warp.weights = {Vec3(weight, 0, 0)};
    warp.kernel = Kernel::r3;
    refuses("the warp of a match leads a pair of its points apart; the file is damaged");
  }
  warp = sound;
  warp.affine.leftCols<3>() = Vec3(1, 1, 0).asDiagonal();
  refuses("a warp makes a plane, a line or a point of space; the file is damaged");
  warp.affine.setZero();
  refuses("a warp makes a plane");
  warp = sound;
  family.matches[0].pairs.clear();
  refuses("a match has no pairs of points; the file is damaged");
}

TEST_F(ReadFamily, RefusesWeightsOfPartsThatAreNoShares) {
  write_changed_parts("0.25", "2.25");
  EXPECT_THAT(message(), HasSubstr("parts.json: a weight is not from 0 to 1; the file is damaged"));
}

TEST_F(ReadFamily, RefusesABoxOfPartsThatIsNone) {
  write_changed_parts("[0.5,2.0,3.0]", "[0.5,-2.0,3.0]");
  EXPECT_THAT(message(), HasSubstr("parts.json: a box has no least and greatest place; the file is damaged"));
}

/// One as turned and scaled as real ones are, so that its matrix has all digits.
struct ReadResult : ReadFamily {
  void SetUp() override {
    family.matches[0].similarity = {1.7, -Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix(), Vec3(1. / 3, 0, 7)};
    family.matches[0].handedness = Handedness::mirrored;
    ReadFamily::SetUp();
  }
};

TEST_F(ReadResult, IsWrittenAgainAsItWas) {
  data.ras = true;
  family.followed.push_back(fixtures::point(1, 2, 3, 4));
  family.matches[0].pairs[1].data = 3;
  family.matches[0].pairs[1].data_point = family.followed[0];
  const Params params = paper_preset();
  const std::string text = match_json(model, data, family, params);
  const homolog::ReadResult read = read_result({text, "match.json"}, std::nullopt);
  EXPECT_EQ(match_json(read.model, read.data, read.family, read.params), text);
  EXPECT_EQ(read.family.matches[0].pairs[1].data_point.position, Vec3(1, 2, 3));
  EXPECT_FALSE(read.parts);
}

TEST_F(ReadResult, HasThePartsAsTheyWere) {
  write_parts(1);
  const homolog::ReadResult read = read_result(folder / "match.json");
  ASSERT_TRUE(read.parts);
  EXPECT_EQ(text_of([&](const Sink& sink) {
              write_parts_json({mesh, read.model}, {mesh, read.data}, *read.parts, sink);
            }),
            read_file(folder / "parts.json"));
}

TEST_F(ReadResult, RefusesWhatIsNotWhole) {
  const auto message = [&](const std::string& from, const std::string& to) {
    std::string text = match_json(model, data, family, {});
    text.replace(text.find(from), from.size(), to);
    return message_of([&] { read_result({text, "match.json"}, std::nullopt); });
  };
  EXPECT_THAT(message("\"mirrored\"", "\"turned\""), HasSubstr("the handedness \"turned\" is not known"));
  EXPECT_THAT(message("\"mirrored\"", "\"proper\""), HasSubstr("a match is told to be proper, but its map is not"));
  EXPECT_THAT(message("\"data\":2", "\"data\":9"), HasSubstr("a pair names a point that is not there"));
  EXPECT_THAT(message("\"data\":2", "\"data\":1e123"), HasSubstr("1e+123 is not a whole number from 0 on; the file is damaged"));
  EXPECT_THAT(message("\"data\":2", "\"data\":-2"), HasSubstr("-2 is not a whole number from 0 on"));
  EXPECT_THAT(message("\"sigma0\"", "\"omega\""), HasSubstr("omega"));
  EXPECT_THAT(message("\"counts\"", "\"count\""), HasSubstr("this is not a file of matches"));
  write_parts(1);
  std::string parts = read_file(folder / "parts.json");
  parts.replace(parts.find("0.25"), 4, "2.25");
  EXPECT_THAT(message_of([&] {
                read_result({match_json(model, data, family, {}), "match.json"}, NamedText{parts, "parts.json"});
              }),
              HasSubstr("parts.json: a weight is not from 0 to 1"));
}

TEST_F(ReadResult, OfAShapeAgainstItselfHasItsSymmetries) {
  data = model;
  std::vector<Symmetry> symmetries{{Plane{Vec3(1, 2, 2) / 3, 0.1}, family.matches[0].similarity, 0.01}};
  const std::string text = symmetries_json(symmetries);
  write_file(folder / "match.json", match_json(model, data, family, {}));
  write_file(folder / "symmetry.json", text);
  EXPECT_EQ(symmetries_json(read_result(folder / "match.json").symmetries.value()), text);
  symmetries[0].mirror.reset();
  write_file(folder / "symmetry.json", symmetries_json(symmetries));
  EXPECT_NEAR(read_result(folder / "match.json").symmetries.value()[0].movement.scale, 1.7, 1e-12);
  write_file(folder / "symmetry.json", symmetries_json({}));
  EXPECT_THAT(message_of([&] { read_result(folder / "match.json"); }), HasSubstr("symmetry.json: it belongs to another match.json"));
  write_file(folder / "symmetry.json", match_json(model, data, family, {}));
  EXPECT_THAT(message_of([&] { read_result(folder / "match.json"); }),
              HasSubstr("its format is \"homolog-match\", not \"homolog-symmetry\""));
}

}  // namespace
}  // namespace homolog
