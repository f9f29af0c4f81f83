// SPDX-License-Identifier: MIT
#include "input_limits.h"

#include <fmt/format.h>

#include "homolog/base/errors.h"
#include "memory_limit.h"
#include "whole_number.h"

namespace homolog::cli {
namespace {

constexpr std::int64_t kMost = 1'000'000'000'000, kMostMebibytes = 1 << 30;

template <class Value>
void add_limit(CLI::App& verb, const char* name, Value& value, const char* what) {
  const auto store = [&value, name](const std::string& text) { value = static_cast<Value>(whole_number(name, text, 1, kMost)); };
  verb.add_option_function<std::string>(name, store, fmt::format("{}; default {}.", what, value))->group("Limits")->type_name("N");
}

}  // namespace

void add_reading_limits(CLI::App& verb, ReadLimits& limits) {
  add_limit(verb, "--max-bytes", limits.bytes, "Refuse files of more bytes");
  add_limit(verb, "--max-triangles", limits.triangles, "Refuse meshes of more triangles, clouds of more points");
  add_limit(verb, "--max-voxels", limits.voxels, "Refuse label volumes of more voxels");
  const auto limit = [](const std::string& text) {
    limit_memory(static_cast<std::uint64_t>(whole_number("--max-memory", text, 0, kMostMebibytes)));
  };
  verb.add_option_function<std::string>(
          "--max-memory", limit,
          "Take no more MiB of memory, 0 for no limit; default what the machine has free, or its container may have.")
      ->group("Limits")
      ->type_name("MIB");
}

void add_limit_options(CLI::App& verb, Limits& limits) {
  add_reading_limits(verb, limits.file);
  add_limit(verb, "--max-points", limits.points, "Refuse shapes with more salient points");
}

void check_points(const Shape& shape, const Limits& limits) {
  if (shape.points.size() <= limits.points) return;
  throw ShapeError(
      fmt::format("it has {} salient points, more than the {} that are matched; a higher --threshold or --sigma0 finds fewer, "
                  "--max-points allows more",
                  shape.points.size(), limits.points));
}

}  // namespace homolog::cli
