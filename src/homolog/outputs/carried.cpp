// SPDX-License-Identifier: MIT
#include "homolog/outputs/carried.h"

#include <fmt/format.h>

#include "homolog/outputs/csv_cells.h"
#include "homolog/outputs/ply.h"

namespace homolog {
namespace {

std::string description(const CarriedLandmark& landmark) {
  if (!landmark.point) return "missing on the shape it comes from";
  const std::string coverage = landmark.point->coverage ? fmt::format(", coverage {:.3f}", *landmark.point->coverage) : "";
  if (!landmark.point->is_there()) return "outside the covered part" + coverage;
  return fmt::format("expected error {:.4g}", landmark.point->expected_error) + coverage;
}

}  // namespace

std::string carried_csv(const std::vector<CarriedLandmark>& landmarks) {
  std::string text = "label,x,y,z,expected_error,coverage\n";
  for (const auto& [label, point] : landmarks) {
    text += csv_cell(label);
    if (point && point->is_there()) {
      const Vec3& x = point->position;
      text += fmt::format(",{},{},{},{},", x.x(), x.y(), x.z(), point->expected_error);
    } else {
      text += ",,,,,";
    }
    text += point && point->coverage ? fmt::format("{:.3f}\n", *point->coverage) : "\n";
  }
  return text;
}

std::vector<MarkupPoint> carried_places(const std::vector<CarriedLandmark>& landmarks) {
  std::vector<MarkupPoint> points;
  for (const CarriedLandmark& landmark : landmarks) {
    const bool is_there = landmark.point && landmark.point->is_there();
    points.push_back({landmark.label, description(landmark), is_there ? std::optional(landmark.point->position) : std::nullopt});
  }
  return points;
}

std::string carried_ply(const Mesh& mesh, const std::vector<CarriedPoint>& vertices) {
  Mesh moved = mesh;
  VertexColumn coverage{"quality", {}}, error{"expected_error", {}};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    moved.vertices[i] = vertices[i].position;
    coverage.values.push_back(vertices[i].exact ? static_cast<float>(vertices[i].coverage.value_or(1)) : 0.0f);
    error.values.push_back(static_cast<float>(vertices[i].expected_error));
  }
  return ply_text(moved, {}, {coverage, error}, "quality: how surely the vertex lies in the covered part, 0 to 1");
}

}  // namespace homolog
