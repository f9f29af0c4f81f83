// SPDX-License-Identifier: MIT
#include "homolog/outputs/write_points.h"

#include <gmock/gmock.h>

#include "homolog/base/errors.h"
#include "homolog/outputs/read_points.h"
#include "homolog/outputs/write_file.h"

namespace homolog {
namespace {

const std::vector<MarkupPoint> points{{"left ear", "", Vec3(0.1, -2, 3e-20)}, {"tail", "", {}}};

TEST(PointsText, OfEveryEndingIsReadBack) {
  for (const char* ending : {".csv", ".mrk.json", ".tps", ".pts", ".txt"}) {
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / ("write_points_test" + std::string(ending));
    write_file(path, points_text(points, path, "bear"));
    const std::vector<MarkupPoint> again = read_points(path);
    ASSERT_EQ(again.size(), 2u) << ending;
    EXPECT_EQ(again[0].label, path.extension() == ".pts" ? "left_ear" : "left ear");
    EXPECT_EQ(again[0].position, points[0].position) << ending;
    EXPECT_FALSE(again[1].position) << ending;
    std::filesystem::remove(path);
  }
}

TEST(PointsText, HoldsLabelsWhateverTheyAre) {
  using namespace std::string_literals;
  const std::vector<CarriedLandmark> carried{{"<b>\"\n\0\x1b[31m"s, CarriedPoint{Vec3(1, 2, 3), true, 0.5, 1}}, {"b", {}}};
  const std::string text = points_text(carried, "a.csv", "");
  EXPECT_EQ(text, "label,x,y,z,expected_error,coverage\n\"<b>\"\"\n  [31m\",1,2,3,0.5,1.000\nb,,,,,\n");
  const std::vector<MarkupPoint> again = read_points_csv(text, "a.csv");
  ASSERT_EQ(again.size(), 2u);
  EXPECT_EQ(again[0].label, "<b>\"\n  [31m");
}

TEST(PointsText, OfCarriedOnesTellsMoreWhereThereIsRoom) {
  const std::vector<CarriedLandmark> carried{{"ear", CarriedPoint{Vec3(1, 2, 3), true, 0.5, 1}}};
  EXPECT_EQ(points_text(carried, "a.csv", ""), carried_csv(carried));
  EXPECT_EQ(points_text(carried, "a.mrk.json", "", true), markups_text(carried_places(carried), true));
  EXPECT_EQ(points_text(points, "a.csv", ""), "label,x,y,z\nleft ear,0.1,-2,3e-20\ntail,,,\n");
}

TEST(PointsText, RefusesOtherEndings) { EXPECT_THROW(points_text(points, "a.fcsv", ""), ParamError); }

}  // namespace
}  // namespace homolog
