// SPDX-License-Identifier: MIT
// The parameter table and the one place where names become members.
#include "homolog/base/parameters.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <functional>

#include "homolog/base/errors.h"

namespace homolog {
namespace {

struct Row {
  ParameterInfo info;
  std::function<void(Params&, double)> set;
  std::function<double(const Params&)> get;
};

template <class Field>
Row row(ParameterInfo info, Field field) {
  using Value = std::remove_reference_t<decltype(field(std::declval<Params&>()))>;
  info.integer = !std::is_same_v<Value, double>;
  if (!info.choices.empty()) info.max = static_cast<double>(info.choices.size()) - 1;
  return {std::move(info), [field](Params& p, double v) { field(p) = static_cast<Value>(v); },
          [field](const Params& p) { return static_cast<double>(field(const_cast<Params&>(p))); }};
}

#define HOMOLOG_FIELD(member) \
  [](Params & p) -> auto& { return p.member; }

// Name, symbol, unit, sentence, min, max, choices. The defaults stand in the structs of the header.
const std::vector<Row>& rows() {
  static const std::vector<Row> table = {
      row({"resolution", "N", "voxels", "Voxels along the longest side of a shape.", 32, 1024, {}, true}, HOMOLOG_FIELD(voxel.resolution)),
      row({"sigma0",
           "sigma_0",
           "voxels",
           "Finest blur of the scale space; the smallest radius found is about 2.2 of it.",
           0.8,
           8,
           {},
           false},
          HOMOLOG_FIELD(salient.sigma0)),
      row({"levels-per-octave", "S", "", "Scales per doubling; k = 2^(1/S).", 2, 8, {}, true}, HOMOLOG_FIELD(salient.levels_per_octave)),
      row({"threshold",
           "t_L",
           "share of a ball's response",
           "Weakest response of a salient point; a plane answers .26, a plate .52, a cylinder .79.",
           0.1,
           1,
           {},
           false},
          HOMOLOG_FIELD(salient.threshold)),
      row({"direction-radius", "rho_0", "r", "Radius of the ball whose centre of mass gives the direction p (eq. 2, 3).", 1, 4, {}, false},
          HOMOLOG_FIELD(salient.direction_radius)),
      row({"direction-min", "t_p", "r", "Shorter offsets of that centre of mass give no direction.", 0, 1, {}, false},
          HOMOLOG_FIELD(salient.direction_min)),
      row({"descriptor",
           "mu",
           "",
           "What descriptors compare: norms free of any frame, or amplitudes about the axis p.",
           0,
           0,
           {"free", "axial"},
           true},
          HOMOLOG_FIELD(descriptor.kind)),
      row({"shells", "", "", "Spacing of the descriptor's shells.", 0, 0, {"logarithmic", "linear"}, true},
          HOMOLOG_FIELD(descriptor.shells)),
      row({"shell-count", "n", "", "Number of concentric shells.", 1, 32, {}, true}, HOMOLOG_FIELD(descriptor.shell_count)),
      row({"degree", "l_max", "", "Highest degree of the spherical harmonics.", 1, 16, {}, true}, HOMOLOG_FIELD(descriptor.degree)),
      row({"inner", "R_min", "r", "Radius of the innermost shell.", 0.1, 4, {}, false}, HOMOLOG_FIELD(descriptor.inner)),
      row({"outer", "rho", "r", "Radius of the outermost shell.", 1, 32, {}, false}, HOMOLOG_FIELD(descriptor.outer)),
      row({"seeds",
           "Q",
           "",
           "What sets grow from: pairs of correspondences, or the paper's cliques of four.",
           0,
           0,
           {"pairs", "quadruples"},
           true},
          HOMOLOG_FIELD(match.seeds)),
      row({"partners", "k", "", "Partners by descriptor that each point keeps, both ways.", 1, 100, {}, true},
          HOMOLOG_FIELD(match.partners)),
      row({"bending", "tau", "model diagonals", "How far shapes may bend: rigid copies .003, posed bodies .015.", 0.0001, 1, {}, false},
          HOMOLOG_FIELD(match.bending)),
      row({"mirror", "", "", "Whether a match may be a mirror image.", 0, 0, {"allow", "forbid", "only"}, true},
          HOMOLOG_FIELD(match.mirror)),
      row({"matches", "n", "", "Most matches in the family.", 1, 100, {}, true}, HOMOLOG_FIELD(match.matches)),
  };
  return table;
}
#undef HOMOLOG_FIELD

const Row& find_row(const std::string& name) {
  for (const Row& row : rows()) {
    if (row.info.name == name) return row;
  }
  throw ParamError(fmt::format("unknown parameter '{}'; 'homolog params' lists all", name));
}

std::string range_text(const ParameterInfo& info) {
  if (!info.choices.empty()) return fmt::format("one of {}", fmt::join(info.choices, ", "));
  return fmt::format("{} to {}", info.min, info.max);
}

void check_value(const ParameterInfo& info, double value, const std::string& text) {
  const bool bad = !(value >= info.min && value <= info.max) || (info.integer && value != std::floor(value));
  if (bad)
    throw ParamError(fmt::format("parameter '{}' is '{}', but must be {}{}", info.name, text,
                                 info.integer && info.choices.empty() ? "a whole number from " : "", range_text(info)));
}

double parse_value(const ParameterInfo& info, const std::string& text) {
  for (std::size_t i = 0; i < info.choices.size(); ++i) {
    if (info.choices[i] == text) return static_cast<double>(i);
  }
  double value = std::nan("");
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && info.choices.empty() ? value : std::nan("");
}

}  // namespace

Params paper_preset() {
  Params params;
  params.voxel.resolution = 128;
  params.salient.sigma0 = 1.2;
  params.salient.direction_radius = 1.5;
  params.descriptor = {DescriptorKind::axial, Shells::linear, 8, 8, 1, 4};
  params.match.seeds = Seeds::quadruples;
  return params;
}

const std::vector<ParameterInfo>& parameter_table() {
  static const std::vector<ParameterInfo> infos = [] {
    std::vector<ParameterInfo> all;
    for (const Row& row : rows()) all.push_back(row.info);
    return all;
  }();
  return infos;
}

ParameterValue get_parameter(const Params& params, const std::string& name) {
  const Row& row = find_row(name);
  const double value = row.get(params);
  if (!row.info.choices.empty()) return row.info.choices.at(static_cast<std::size_t>(value));
  if (row.info.integer) return static_cast<long>(value);
  return value;
}

void set_parameter(Params& params, const std::string& name, const std::string& value) {
  const Row& row = find_row(name);
  const double number = parse_value(row.info, value);
  check_value(row.info, number, value);
  row.set(params, number);
}

std::string to_text(const ParameterValue& value) {
  return std::visit([](const auto& v) { return fmt::format("{}", v); }, value);
}

void check(const Params& params) {
  for (const Row& row : rows()) {
    const double value = row.get(params);
    check_value(row.info, value, fmt::format("{}", value));
  }
}

}  // namespace homolog
