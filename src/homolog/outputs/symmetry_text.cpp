// SPDX-License-Identifier: MIT
#include "homolog/outputs/symmetry_text.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "homolog/outputs/json_text.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

constexpr const char* format = "homolog-symmetry";
constexpr double least_error = 1e-5;  // in diagonals; smaller ones are a matter of rounding

/// Without the sign of a zero.
double rounded(double x) { return std::round(x * 1e4) / 1e4 + 0.0; }

std::string told(const Vec3& x) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", x.x(), x.y(), x.z()); }

bool is_mirrored(const Mat3& rotation) { return rotation.determinant() < 0; }

/// What follows the negation of x, if that comes first.
Mat3 unmirrored(const Mat3& rotation) { return is_mirrored(rotation) ? Mat3(rotation * Vec3(-1, 1, 1).asDiagonal()) : rotation; }

std::string movement_of(const Symmetry& symmetry) {
  if (symmetry.mirror) {
    const auto& [normal, offset] = *symmetry.mirror;
    return fmt::format("mirrored in the plane {:.4f} x {:+.4f} y {:+.4f} z = {:.4g}", rounded(normal.x()), rounded(normal.y()),
                       rounded(normal.z()), offset);
  }
  const auto& [scale, rotation, shift] = symmetry.movement;
  const Eigen::AngleAxisd turn(unmirrored(rotation));
  return fmt::format("repeated{}, {:.3f} times as large, turned by {:.1f} degrees about {}, then shifted by {}",
                     is_mirrored(rotation) ? " as its mirror image (x negated first)" : "", scale, turn.angle() * 180 / M_PI,
                     told(turn.axis()), told(shift));
}

ordered_json list_of(const Vec3& x) { return {x.x(), x.y(), x.z()}; }

ordered_json to_json(const Symmetry& symmetry) {
  if (symmetry.mirror) {
    return {
        {"kind", "mirrored"}, {"normal", list_of(symmetry.mirror->normal)}, {"offset", symmetry.mirror->offset}, {"error", symmetry.error}};
  }
  const auto& [scale, rotation, shift] = symmetry.movement;
  const Eigen::AngleAxisd turn(unmirrored(rotation));
  return {{"kind", "repeated"},           {"mirrored", is_mirrored(rotation)},    {"scale", scale},
          {"axis", list_of(turn.axis())}, {"degrees", turn.angle() * 180 / M_PI}, {"shift", list_of(shift)},
          {"error", symmetry.error}};
}

}  // namespace

std::string symmetry_sentence(const Symmetry& symmetry) {
  return fmt::format("{}; it lies within {:.2g} % of the diagonal (root mean square)", movement_of(symmetry),
                     100 * std::max(symmetry.error, least_error));
}

std::string symmetries_text(const std::vector<Symmetry>& symmetries) {
  std::string text;
  for (std::size_t i = 0; i < symmetries.size(); ++i) {
    text += fmt::format("{:4}  {}\n", i + 1, symmetry_sentence(symmetries[i]));
  }
  return text;
}

std::string symmetries_json(const std::vector<Symmetry>& symmetries) {
  ordered_json list = ordered_json::array();
  for (const Symmetry& symmetry : symmetries) list.push_back(to_json(symmetry));
  ordered_json json = json_head(format);
  json["symmetries"] = list;
  return json_text(json);
}

std::vector<Symmetry> read_symmetries(const std::string& text, const std::string& file, const std::vector<Match>& matches) {
  return read_json(text, file, "symmetries", [&](const ordered_json& json) {
    check_head(json, format, file);
    const ordered_json& list = json.at("symmetries");
    if (list.size() != matches.size())
      throw FileError(fmt::format("{}: it belongs to another match.json than the one beside it; run 'homolog symmetry --out' again", file));
    std::vector<Symmetry> symmetries;
    for (std::size_t i = 0; i < matches.size(); ++i) {
      symmetries.push_back({std::nullopt, matches[i].similarity, list[i].at("error")});
      if (list[i].at("kind") != "mirrored") continue;
      const auto normal = list[i].at("normal").get<std::array<double, 3>>();
      symmetries.back().mirror = Plane{{normal[0], normal[1], normal[2]}, list[i].at("offset")};
    }
    return symmetries;
  });
}

}  // namespace homolog
