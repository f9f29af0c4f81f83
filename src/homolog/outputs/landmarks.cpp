// SPDX-License-Identifier: MIT
// Landmark lists and their two file formats.
#include "homolog/outputs/landmarks.h"

#include <fmt/format.h>

#include "homolog/outputs/markups.h"

namespace homolog {
namespace {

std::vector<Landmark> pair_landmarks(const Match& match, SalientPoint Correspondence::*side) {
  std::vector<Landmark> landmarks;
  for (const Correspondence& pair : match.pairs) {
    landmarks.push_back({fmt::format("L{:03}", landmarks.size() + 1), pair.*side, pair.confidence});
  }
  return landmarks;
}

std::string description(const Landmark& landmark) {
  const std::string text = fmt::format("radius {:.4g}, response {:.3f}", landmark.point.radius, landmark.point.response);
  return landmark.confidence ? text + fmt::format(", confidence {:.3f}", *landmark.confidence) : text;
}

}  // namespace

std::vector<Landmark> model_landmarks(const Match& match) { return pair_landmarks(match, &Correspondence::model_point); }
std::vector<Landmark> data_landmarks(const Match& match) { return pair_landmarks(match, &Correspondence::data_point); }

std::vector<Landmark> point_landmarks(const Shape& shape) {
  std::vector<Landmark> landmarks;
  for (const SalientPoint& point : shape.points) landmarks.push_back({fmt::format("P{:03}", landmarks.size() + 1), point, {}});
  return landmarks;
}

std::string landmarks_csv(const std::vector<Landmark>& landmarks) {
  std::string text = "label,x,y,z,radius,direction_x,direction_y,direction_z,response,confidence\n";
  for (const auto& [label, point, confidence] : landmarks) {
    const Vec3 &x = point.position, &p = point.direction;
    text += fmt::format("{},{},{},{},{},", label, x.x(), x.y(), x.z(), point.radius);
    text += point.direction_length > 0 ? fmt::format("{},{},{},", p.x(), p.y(), p.z()) : ",,,";
    text += fmt::format("{},{}\n", point.response, confidence ? fmt::format("{}", *confidence) : "");
  }
  return text;
}

std::string landmarks_markups(const std::vector<Landmark>& landmarks, bool ras) {
  std::vector<MarkupPoint> points;
  for (const Landmark& landmark : landmarks) points.push_back({landmark.label, description(landmark), landmark.point.position});
  return markups_text(points, ras);
}

}  // namespace homolog
