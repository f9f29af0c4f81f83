// SPDX-License-Identifier: MIT
#include "homolog/outputs/carried.h"

#include <fmt/format.h>

#include <cmath>

#include "homolog/outputs/csv_cells.h"
#include "homolog/outputs/ply.h"

namespace homolog {
namespace {

constexpr const char* was_missing = "missing on the shape it comes from";
constexpr const char* not_covered = "outside the covered part";
constexpr const char* no_inverse = "the map folds here";
constexpr const char* error_to_expect = "expected error ";

std::string told(const std::optional<CarriedPoint>& point) {
  if (!point) return was_missing;
  const std::string coverage = point->coverage ? fmt::format(", coverage {:.3f}", *point->coverage) : "";
  if (!point->is_covered()) return not_covered + coverage;
  if (!point->exact) return no_inverse + coverage;
  return fmt::format("{}{:.4g}", error_to_expect, point->expected_error) + coverage;
}

/// A description without what told() added to it on another way.
std::string before_told(const std::string& description) {
  const std::size_t last = description.rfind("; "), begin = last == description.npos ? 0 : last + 2;
  const std::string_view tail = std::string_view(description).substr(begin);
  const auto begins = [&](const char* words) { return tail.starts_with(words); };
  if (!begins(was_missing) && !begins(not_covered) && !begins(no_inverse) && !begins(error_to_expect)) return description;
  return last == description.npos ? "" : description.substr(0, last);
}

std::string description_of(const CarriedLandmark& landmark) {
  const std::string before = before_told(landmark.description);
  return before + (before.empty() ? "" : "; ") + told(landmark.point);
}

}  // namespace

bool is_finite(const CarriedPoint& point) {
  return point.position.allFinite() && std::isfinite(static_cast<float>(point.expected_error));  // in a .ply it is a float
}

std::string carried_csv(const std::vector<CarriedLandmark>& landmarks) {
  std::string text = "label,x,y,z,expected_error,coverage\n";
  for (const CarriedLandmark& landmark : landmarks) {
    const auto& point = landmark.point;
    text += csv_cell(landmark.label);
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
    points.push_back(
        {landmark.label, description_of(landmark), is_there ? std::optional(landmark.point->position) : std::nullopt, landmark.display});
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
  return ply_text(moved, {}, {coverage, error},
                  "quality: how surely the vertex lies in the covered part, 0 to 1; below 0.5 it is missing on the other shape, "
                  "and its place only where the map would put it");
}

}  // namespace homolog
