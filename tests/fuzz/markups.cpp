// SPDX-License-Identifier: MIT
// Markups of 3D Slicer; what was read is written and read again, and must be the same.
#include "homolog/outputs/markups.h"

#include "fuzz/target.h"

namespace homolog::fuzz {
namespace {

void run(const std::string& bytes) {
  std::vector<MarkupPoint> points;
  try {
    points = read_markups(bytes, "fuzzed");
  } catch (const FileError& error) {
    return require_one_line(error);
  }
  std::vector<MarkupList> lists;
  try {
    lists = read_markup_lists(bytes, "fuzzed");
  } catch (const FileError& error) {
    return require_one_line(error);
  }
  const std::vector<MarkupPoint> again = read_markups(markups_text(points, false, lists), "written");
  require(again.size() == points.size(), "as many points are read as were written");
  for (std::size_t i = 0; i < points.size(); ++i) {
    require(!points[i].position || points[i].position->allFinite(), "coordinates are finite");
    require(points[i].position == again[i].position && points[i].label == again[i].label, "a point is read as it was written");
  }
}

}  // namespace

Target markups() {
  const MarkupPoint nose{"nose", "of a bear", Vec3(1, 2, 3)}, gone{"gone \u00e4", "", {}};
  return {"markups",
          {markups_text({nose, gone}),
           R"({"markups":[{"coordinateSystem":"RAS","controlPoints":[{"label":"a","position":[1,-2e300,3]},{"position":[0,0,0]}]}]})",
           R"({"markups":[{"controlPoints":[{"positionStatus":"undefined"},{"position":[1,2]}]}]})", R"({"markups":{}})"},
          run};
}

}  // namespace homolog::fuzz
