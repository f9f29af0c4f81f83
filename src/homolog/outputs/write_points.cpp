// SPDX-License-Identifier: MIT
#include "homolog/outputs/write_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "homolog/base/errors.h"
#include "homolog/base/read_file.h"
#include "homolog/outputs/csv_cells.h"
#include "homolog/outputs/landmark_editor.h"
#include "homolog/outputs/morphologika.h"
#include "homolog/outputs/tps.h"

namespace homolog {
namespace {

std::string points_csv(const std::vector<MarkupPoint>& points) {
  std::string text = "label,x,y,z\n";
  for (const MarkupPoint& point : points) {
    const auto& position = point.position;
    text += csv_cell(point.label) + (position ? fmt::format(",{},{},{}\n", position->x(), position->y(), position->z()) : ",,,\n");
  }
  return text;
}

}  // namespace

bool writes_points(const std::filesystem::path& path) {
  constexpr std::array endings{".csv", ".json", ".tps", ".pts", ".txt"};
  return std::find(endings.begin(), endings.end(), lower_extension(path)) != endings.end();
}

std::string points_text(const std::vector<MarkupPoint>& points, const std::filesystem::path& path, const std::string& specimen, bool ras,
                        const std::vector<MarkupList>& lists) {
  if (!writes_points(path)) throw ParamError(fmt::format("points are written as {}, not as '{}'", writable_points, path.string()));
  const std::string ending = lower_extension(path);
  if (ending == ".csv") return points_csv(points);
  if (ending == ".json") return markups_text(points, ras, lists);
  if (ending == ".pts") return pts_text(points);
  return ending == ".tps" ? tps_text({specimen, points}) : morphologika_text({specimen, points});
}

std::string points_text(const std::vector<CarriedLandmark>& landmarks, const std::filesystem::path& path, const std::string& specimen,
                        bool ras, const std::vector<MarkupList>& lists) {
  return lower_extension(path) == ".csv" ? carried_csv(landmarks) : points_text(carried_places(landmarks), path, specimen, ras, lists);
}

}  // namespace homolog
