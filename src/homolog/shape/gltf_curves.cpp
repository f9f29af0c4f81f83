// SPDX-License-Identifier: MIT
#include "homolog/shape/gltf_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "homolog/base/errors.h"
#include "homolog/shape/gltf_table.h"

namespace homolog {
namespace {

using nlohmann::json;

constexpr std::size_t most_values = 50'000'000;
constexpr double cubic_step = 1.0 / 30, before_step = 0.001;  // seconds

std::optional<GltfPath> path_of(const std::string& name) {
  static const std::map<std::string, GltfPath> paths = {
      {"translation", GltfPath::translation}, {"rotation", GltfPath::rotation}, {"scale", GltfPath::scale}, {"weights", GltfPath::weights}};
  const auto found = paths.find(name);
  return found == paths.end() ? std::nullopt : std::optional(found->second);
}

std::size_t needed(const GltfFile& file, const json& object, const char* key) {
  const auto number = number_at(file, object, key);
  if (!number) fail(file, fmt::format("an animation does not name its '{}'", key));
  return *number;
}

GltfCurve read_curve(const GltfFile& file, const json& sampler, GltfPath path) {
  GltfCurve curve;
  const std::string between = text_at(sampler, "interpolation");
  if (between == "STEP") curve.between = GltfCurve::Between::step;
  if (between == "CUBICSPLINE") curve.between = GltfCurve::Between::cubic;
  curve.turns = path == GltfPath::rotation;
  curve.times = read_gltf_table(file, needed(file, sampler, "input"), {"times", {1}, {}}).values;
  if (curve.times.empty() || curve.times[0] < 0 || !std::is_sorted(curve.times.begin(), curve.times.end(), std::less_equal<>())) {
    fail(file, "the times of an animation do not ascend from 0 on");
  }
  const std::size_t columns = path == GltfPath::weights ? 1 : curve.turns ? 4 : 3;
  curve.values = read_gltf_table(file, needed(file, sampler, "output"), {"values of an animation", {columns}, {}}).values;
  const std::size_t entries = curve.times.size() * (curve.between == GltfCurve::Between::cubic ? 3 : 1);
  curve.width = path == GltfPath::weights ? curve.values.size() / entries : columns;
  if (curve.width == 0 || curve.values.size() != entries * curve.width) fail(file, "an animation has not one value for each time");
  return curve;
}

/// Which of the three parts of a cubic entry.
enum Part : std::size_t { kIncoming = 0, kValue = 1, kOutgoing = 2 };

double entry_at(const GltfCurve& curve, std::size_t i, std::size_t k, Part part = kValue) {
  return curve.values[(curve.between == GltfCurve::Between::cubic ? 3 * i + part : i) * curve.width + k];
}

/// Between entries i and i + 1, which `span` seconds part, at the share t.
double cubic(const GltfCurve& curve, std::size_t i, std::size_t k, double t, double span) {
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * entry_at(curve, i, k) + span * (t3 - 2 * t2 + t) * entry_at(curve, i, k, kOutgoing) +
         (3 * t2 - 2 * t3) * entry_at(curve, i + 1, k) + span * (t3 - t2) * entry_at(curve, i + 1, k, kIncoming);
}

Eigen::Quaterniond turn_of(const std::vector<double>& values) {
  const Eigen::Quaterniond turn(values[3], values[0], values[1], values[2]);
  return turn.squaredNorm() > 0 ? turn.normalized() : Eigen::Quaterniond::Identity();
}

}  // namespace

std::vector<GltfChannel> read_gltf_channels(const GltfFile& file, const json& animation) {
  std::vector<GltfChannel> channels;
  std::size_t values = 0;
  const auto list = animation.find("channels"), samplers = animation.find("samplers");
  if (list == animation.end() || !list->is_array() || samplers == animation.end() || !samplers->is_array()) return channels;
  for (const json& channel : *list) {
    const auto target = channel.find("target");
    if (target == channel.end() || !target->is_object()) continue;
    const auto node = number_at(file, *target, "node");
    const auto path = path_of(text_at(*target, "path"));
    if (!node || !path) continue;
    const std::size_t sampler = needed(file, channel, "sampler");
    if (sampler >= samplers->size()) fail(file, fmt::format("sampler {} of an animation does not exist", sampler));
    channels.push_back({*node, *path, read_curve(file, (*samplers)[sampler], *path)});
    values += channels.back().curve.values.size();
    if (values > most_values) {
      throw FileError(fmt::format("{}: an animation holds more than the {} numbers that are read; leave it out", file.name, most_values));
    }
  }
  return channels;
}

std::vector<double> values_at(const GltfCurve& curve, double time) {
  const auto after = std::upper_bound(curve.times.begin(), curve.times.end(), time);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - curve.times.begin() - 1));
  const bool stands = i + 1 == curve.times.size() || time <= curve.times[i] || curve.between == GltfCurve::Between::step;
  std::vector<double> values, next;
  for (std::size_t k = 0; k < curve.width; ++k) values.push_back(entry_at(curve, i, k));
  if (stands) return values;
  const double span = curve.times[i + 1] - curve.times[i], t = (time - curve.times[i]) / span;
  for (std::size_t k = 0; k < curve.width; ++k) next.push_back(entry_at(curve, i + 1, k));
  if (curve.turns && curve.between == GltfCurve::Between::straight) {
    const Eigen::Quaterniond turn = turn_of(values).slerp(t, turn_of(next));
    return {turn.x(), turn.y(), turn.z(), turn.w()};
  }
  for (std::size_t k = 0; k < curve.width; ++k) {
    const bool straight = curve.between == GltfCurve::Between::straight;
    values[k] = straight ? (1 - t) * values[k] + t * next[k] : cubic(curve, i, k, t, span);
  }
  return values;
}

std::vector<double> times_of(const std::vector<GltfChannel>& channels, std::size_t most) {
  std::vector<double> times;
  for (const GltfChannel& channel : channels) {
    const std::vector<double>& own = channel.curve.times;
    times.insert(times.end(), own.begin(), own.end());
    for (std::size_t i = 1; i < own.size(); ++i) {
      const double span = own[i] - own[i - 1];
      if (channel.curve.between == GltfCurve::Between::step && span > 2 * before_step) times.push_back(own[i] - before_step);
      if (channel.curve.between != GltfCurve::Between::cubic) continue;
      const double parts = std::ceil(span / cubic_step);
      for (double k = 1; k < parts && times.size() <= most; ++k) times.push_back(own[i - 1] + k / parts * span);
    }
  }
  std::sort(times.begin(), times.end());
  const auto same = [](double a, double b) { return static_cast<float>(a) == static_cast<float>(b); };
  times.erase(std::unique(times.begin(), times.end(), same), times.end());
  return times;
}

}  // namespace homolog
