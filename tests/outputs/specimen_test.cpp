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
              HasSubstr("a.tps: it holds 3 specimens; choose one by its name or number with --specimen: 1 anna, 2 2, 3 (no name)"));
  EXPECT_THAT(message_of([] { chosen_specimen(collection, "otto", "a.tps"); }), HasSubstr("it holds no specimen 'otto', but 1 anna"));
  EXPECT_THAT(message_of([] { chosen_specimen({}, "", "a.tps"); }), HasSubstr("it holds no landmarks"));
}

}  // namespace
}  // namespace homolog
