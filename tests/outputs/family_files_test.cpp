// SPDX-License-Identifier: MIT
#include "homolog/outputs/family_files.h"

#include <gmock/gmock.h>

#include "homolog/outputs/match_json.h"
#include "outputs/match_fixture.h"

namespace homolog {
namespace {

struct FamilyFiles : testing::Test {
  Shape model = fixtures::shape("model.off", 1), data = fixtures::shape("data.off", 2);
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  Params params;

  std::map<std::string, std::string> texts(const Family& family, const std::vector<MatchParts>& parts,
                                           const std::optional<std::vector<Symmetry>>& symmetries) const {
    const ToldFamily told{{mesh, model}, {mesh, data}, family, params, parts, symmetries};
    std::map<std::string, std::string> texts;
    for (const auto& [name, writing] : family_files(told)) texts[name] = text_of(writing);
    return texts;
  }
};

TEST_F(FamilyFiles, TellAFamily) {
  const Family family = fixtures::family(model, data);
  const auto files = texts(family, {{{{1, 0, 1}, {}}, {{1, 1, 1}, {}}}}, {});
  EXPECT_EQ(files.at("match.json"), match_json(model, data, family, params));
  EXPECT_THAT(files.at("model.landmarks.csv"), testing::HasSubstr("L002"));
  EXPECT_FALSE(files.contains("symmetry.json"));
  EXPECT_TRUE(texts(family, {{{{1, 0, 1}, {}}, {{1, 1, 1}, {}}}}, std::vector<Symmetry>(1)).contains("symmetry.json"));
}

TEST_F(FamilyFiles, OfAnEmptyFamilyAreTheSameFiles) {
  const auto full = texts(fixtures::family(model, data), {{{{1, 0, 1}, {}}, {{1, 1, 1}, {}}}}, {}), empty = texts({}, {}, {});
  EXPECT_EQ(empty.size(), full.size());
  EXPECT_THAT(empty.at("model.part.ply"), testing::HasSubstr("0 0 0 204 212 219 0\n")) << "nothing is covered";
}

}  // namespace
}  // namespace homolog
