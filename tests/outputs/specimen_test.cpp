// SPDX-License-Identifier: MIT
#include "homolog/outputs/specimen.h"

#include <gmock/gmock.h>

#include "outputs/message_of.h"

namespace homolog {
namespace {

using testing::HasSubstr;

const std::vector<Specimen> collection{{"anna", {}}, {"2", {}}, {"", {}}};

TEST(ChosenSpecimen, GoesByNameThenByNumber) {
  EXPECT_EQ(&chosen_specimen(collection, "anna", "a.tps"), &collection[0]);
  EXPECT_EQ(&chosen_specimen(collection, "2", "a.tps"), &collection[1]);
  EXPECT_EQ(&chosen_specimen(collection, "3", "a.tps"), &collection[2]);
  const std::vector<Specimen> one{{"anna", {}}};
  EXPECT_EQ(&chosen_specimen(one, "", "a.tps"), &one[0]);
}

TEST(ChosenSpecimen, NeverGuesses) {
  EXPECT_THAT(message_of([] { chosen_specimen(collection, "", "a.tps"); }),
              HasSubstr("a.tps: it holds 3 specimens; say which one is meant by its name or number (--specimen; in Python specimen=): 1 "
                        "anna, 2 2, 3 (no name)"));
  EXPECT_THAT(message_of([] { chosen_specimen(collection, "otto", "a.tps"); }), HasSubstr("it holds no specimen 'otto', but 1 anna"));
  const std::vector<Specimen> again{{"anna", {}}, {"otto", {}}, {"anna", {}}};
  EXPECT_THAT(message_of([&] { chosen_specimen(again, "anna", "a.tps"); }), HasSubstr("2 specimens have the name 'anna'"));
  EXPECT_EQ(&chosen_specimen(again, "3", "a.tps"), &again[2]);
  EXPECT_THAT(message_of([] { chosen_specimen({}, "", "a.tps"); }), HasSubstr("it holds no landmarks"));
}

TEST(NameComment, IsTakenBackAsTheName) {
  for (const char* name : {"nose", "left ear: tip, L", "3", "C1.1"}) {
    std::vector<MarkupPoint> points{{"1", "", {}}, {"2", "", {}}};
    take_name(name_comment({name, "", {}}, 2), points);
    EXPECT_EQ(points[0].label, "1");
    EXPECT_EQ(points[1].label, name);
  }
  EXPECT_EQ(name_comment({"2", "", {}}, 2), "") << "its number is no name";
  EXPECT_EQ(name_comment({" ", "", {}}, 2), "");
  EXPECT_EQ(name_comment({"a\nb", "", {}}, 2), "landmark 2: a b");
}

TEST(TakeName, LeavesOtherCommentsAlone) {
  std::vector<MarkupPoint> points{{"1", "", {}}};
  for (const char* comment : {"", "landmark", "landmark 1", "landmark 1:", "landmark 2: x", "landmark 0: x", "landmark -1: x",
                              "landmark 1.5: x", "landmark 99999999999999999999: x", "landmarks 1: x", "placed by anna"}) {
    take_name(comment, points);
    EXPECT_EQ(points[0].label, "1") << comment;
  }
}

}  // namespace
}  // namespace homolog
