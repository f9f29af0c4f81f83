// SPDX-License-Identifier: MIT
#include "homolog/outputs/morphologika.h"

#include <gmock/gmock.h>

#include "outputs/message_of.h"

namespace homolog {
namespace {

using testing::HasSubstr;

std::string with(const std::string& individuals, const std::string& landmarks, const std::string& rest,
                 const std::string& dimensions = "3") {
  return "[individuals]\n" + individuals + "\n[landmarks]\n" + landmarks + "\n[dimensions]\n" + dimensions + "\n" + rest;
}

std::string message(const std::string& text) {
  return message_of([&] { read_morphologika(text, "a.txt"); });
}

TEST(Morphologika, ReadsBackWhatItWritesMissingOnesUndefined) {
  const Specimen specimen{"bear 1", {{"nose", "", Vec3(0.1, -2, 3e-20)}, {"\"left\" ear", "", {}}}};
  EXPECT_EQ(morphologika_text(specimen), "\"landmark 1: nose\"\n\"landmark 2: \"left\" ear\"\n" +
                                             with("1", "2", "[names]\nbear 1\n[rawpoints]\n'bear 1\n0.1 -2 3e-20\nNA NA NA\n"));
  const auto specimens = read_morphologika(morphologika_text(specimen), "a.txt");
  ASSERT_EQ(specimens.size(), 1u);
  EXPECT_EQ(specimens[0].name, "bear 1");
  ASSERT_EQ(specimens[0].points.size(), 2u);
  EXPECT_EQ(specimens[0].points[0].position, specimen.points[0].position);
  EXPECT_FALSE(specimens[0].points[1].position);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(specimens[0].points[i].label, specimen.points[i].label);
}

TEST(Morphologika, ReadsCollectionsAndLeavesOtherSectionsOut) {
  const auto specimens = read_morphologika(
      with("2", "2",
           "[Names]\r\na\r\nb\r\n[labels]\r\nsex\r\n[labelvalues]\r\nm\r\nf\r\n\"a comment\r\n[rawpoints]\r\n'#1\r\n\r\n1 2 3\r\n"
           "9999 9999 9999\r\n'#2\r\n\t4  5 6\r\n7 8 9\r\n[wireframe]\r\n1 2\r\n"),
      "a.txt");
  ASSERT_EQ(specimens.size(), 2u);
  EXPECT_EQ(specimens[1].name, "b");
  EXPECT_FALSE(specimens[0].points[1].position);
  EXPECT_EQ(specimens[1].points[0].position, Vec3(4, 5, 6));
  EXPECT_EQ(specimens[1].points[0].label, "1");
}

TEST(Morphologika, ReadsBackNamesThatBeginLikeSectionsAndComments) {
  for (const std::string name : {"[individuals]", "\"[old\" bear", " [", "'bear"}) {
    const auto specimens = read_morphologika(morphologika_text({name, {{"1", "", Vec3(1, 2, 3)}}}), "a.txt");
    ASSERT_EQ(specimens.size(), 1u) << name;
    EXPECT_EQ(specimens[0].points.size(), 1u) << name;
  }
}

TEST(Morphologika, NamesTheLineOfAnError) {
  EXPECT_THAT(message("1 2 3\n"), HasSubstr("a.txt, line 1: a section such as [individuals] must come first"));
  EXPECT_THAT(message("[individuals]\n1\n[landmarks]\n[dimensions]\n3\n"), HasSubstr("the section [landmarks] is missing or empty"));
  EXPECT_THAT(message(with("1", "1", "[rawpoints]\n1 2\n", "2")), HasSubstr("line 6: landmarks with 2 coordinates lie on no surface"));
  EXPECT_THAT(message(with("1", "1", "")), HasSubstr("the section [rawpoints] is missing"));
  EXPECT_THAT(message(with("1", "2", "[rawpoints]\n1 2 3\n")),
              HasSubstr("line 8: [rawpoints] holds 1 rows, but 1 individuals with 2 landmarks"));
  EXPECT_THAT(message(with("1", "1", "[rawpoints]\n1 two 3\n")), HasSubstr("line 8: 'two' is not a finite number"));
  EXPECT_THAT(message(with("1", "1", "[rawpoints]\n1 NA 3\n")), HasSubstr("line 8: some coordinates are missing"));
  EXPECT_THAT(message(with("-1", "1", "")), HasSubstr("line 2: -1 cannot be the number of [individuals]"));
  EXPECT_THAT(message("[a]\n[a]\n"), HasSubstr("line 2: the section [a] stands twice"));
}

}  // namespace
}  // namespace homolog
