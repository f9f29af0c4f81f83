// SPDX-License-Identifier: MIT
#include "homolog/outputs/markups.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "homolog/base/errors.h"
#include "homolog/outputs/json_text.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

// As Slicer itself writes it, lower-case organisation and closing '#' included: its reader looks for the version in there.
constexpr const char* kMarkupsSchema =
    "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/markups-schema-v1.0.3.json#";

ordered_json control_point(const MarkupPoint& point, std::size_t number) {
  ordered_json json = {{"id", fmt::format("{}", number)}, {"label", point.label}, {"description", point.description}};
  if (point.position) json["position"] = {point.position->x(), point.position->y(), point.position->z()};
  json["selected"] = point.display.selected;
  json["locked"] = point.display.locked;
  json["visibility"] = point.display.visible;
  json["positionStatus"] = point.position ? "defined" : "undefined";
  return json;
}

/// The turn of the signs from a markup's coordinates to LPS, which is the schema's default for "coordinateSystem", too.
Vec3 lps_signs(const ordered_json& markup, const std::string& file) {
  const std::string system = markup.value("coordinateSystem", "LPS");
  if (system == "LPS") return {1, 1, 1};
  if (system == "RAS") return {-1, -1, 1};
  throw FileError(fmt::format("{}: the coordinate system '{}' is not known; save the points as LPS or RAS", file, shown(system)));
}

/// What is no truth value says nothing; no point is refused for how it is shown.
bool flag(const ordered_json& json, const char* key, bool otherwise) {
  return json.contains(key) && json[key].is_boolean() ? json[key].get<bool>() : otherwise;
}

MarkupPoint read_point(const ordered_json& json, const Vec3& signs, const std::string& file) {
  MarkupPoint point{json.value("label", ""), json.value("description", ""), {}};
  point.display = {flag(json, "selected", true), flag(json, "locked", false), flag(json, "visibility", true)};
  if (json.value("positionStatus", "defined") != "defined" || !json.contains("position")) return point;
  const auto x = json["position"].get<std::vector<double>>();
  if (x.size() != 3)
    throw FileError(fmt::format("{}, point '{}': a position has three coordinates, not {}", file, shown(point.label), x.size()));
  point.position = signs.cwiseProduct(Vec3(x[0], x[1], x[2]));
  return point;
}

}  // namespace

std::string markups_text(const std::vector<MarkupPoint>& points, bool ras, const std::vector<MarkupList>& lists) {
  ordered_json markups = ordered_json::array();
  std::size_t next = 0;
  for (const MarkupList& list : lists.empty() ? std::vector{MarkupList{points.size()}} : lists) {
    ordered_json markup = {{"type", list.type}};
    if (!list.name.empty()) markup["name"] = list.name;
    markup["coordinateSystem"] = ras ? "RAS" : "LPS";
    if (!list.units.empty()) markup["coordinateUnits"] = list.units;
    ordered_json& control_points = markup["controlPoints"] = ordered_json::array();
    for (std::size_t i = 0; i < list.points; ++i) control_points.push_back(control_point(points.at(next++), i + 1));
    markups.push_back(std::move(markup));
  }
  return json_text({{"@schema", kMarkupsSchema}, {"markups", std::move(markups)}});
}

std::vector<MarkupList> read_markup_lists(const std::string& text, const std::string& file) {
  static const std::string types[] = {"Fiducial", "Line", "Angle", "Curve", "ClosedCurve"};
  return read_json(text, file, "markups of 3D Slicer", [&](const ordered_json& json) {
    std::vector<MarkupList> lists;
    for (const ordered_json& markup : json.at("markups")) {
      MarkupList list{markup.at("controlPoints").size(), markup.value("type", "Fiducial"), markup.value("name", ""),
                      markup.value("coordinateUnits", "")};
      if (std::find(std::begin(types), std::end(types), list.type) == std::end(types)) {
        list.dropped = std::exchange(list.type, "Fiducial");
      }
      lists.push_back(std::move(list));
    }
    return lists;
  });
}

std::vector<MarkupPoint> read_markups(const std::string& text, const std::string& file) {
  return read_json(text, file, "markups of 3D Slicer", [&](const ordered_json& json) {
    std::vector<MarkupPoint> points;
    for (const ordered_json& markup : json.at("markups")) {
      const Vec3 signs = lps_signs(markup, file);
      for (const ordered_json& point : markup.at("controlPoints")) points.push_back(read_point(point, signs, file));
    }
    return points;
  });
}

}  // namespace homolog
