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
std::vector<Row> voxel_rows() {
  return {
      row({"resolution", "N", "voxels", "Voxels along the longest side of a shape.", 32, 1024}, HOMOLOG_FIELD(voxel.resolution)),
      row({"thicken", "", "diagonals", "Thickness to give the surface, so that sheets have an inside.", 0, 0.2},
          HOMOLOG_FIELD(voxel.thicken)),
  };
}

std::vector<Row> salient_rows() {
  return {
      row({"sigma0", "sigma_0", "voxels", "Finest blur of the scale space; the smallest radius found is about 2.2 of it.", 0.8, 8},
          HOMOLOG_FIELD(salient.sigma0)),
      row({"levels-per-octave", "S", "", "Scales per doubling; k = 2^(1/S).", 2, 8}, HOMOLOG_FIELD(salient.levels_per_octave)),
      row({"threshold", "t_L", "share of a ball's response",
           "Weakest response of a salient point; a plane answers .26, a plate .52, a cylinder .79.", 0.1, 1},
          HOMOLOG_FIELD(salient.threshold)),
      row({"direction-radius", "rho_0", "r", "Radius of the ball whose centre of mass gives the direction p (eq. 2, 3).", 1, 4},
          HOMOLOG_FIELD(salient.direction_radius)),
      row({"direction-min", "t_p", "r", "Shorter offsets of that centre of mass give no direction.", 0, 1},
          HOMOLOG_FIELD(salient.direction_min)),
  };
}

std::vector<Row> descriptor_rows() {
  return {
      row({"descriptor",
           "mu",
           "",
           "What descriptors compare: norms free of any frame, or amplitudes about the axis p.",
           0,
           0,
           {"free", "axial"}},
          HOMOLOG_FIELD(descriptor.kind)),
      row({"shells", "", "", "Spacing of the descriptor's shells.", 0, 0, {"logarithmic", "linear"}}, HOMOLOG_FIELD(descriptor.shells)),
      row({"shell-count", "n", "", "Number of concentric shells.", 1, 32}, HOMOLOG_FIELD(descriptor.shell_count)),
      row({"degree", "l_max", "", "Highest degree of the spherical harmonics.", 1, 16}, HOMOLOG_FIELD(descriptor.degree)),
      row({"inner", "R_min", "r", "Radius of the innermost shell.", 0.1, 4}, HOMOLOG_FIELD(descriptor.inner)),
      row({"outer", "rho", "r", "Radius of the outermost shell.", 1, 32}, HOMOLOG_FIELD(descriptor.outer)),
  };
}

std::vector<Row> match_rows() {
  return {
      row({"seeds",
           "Q",
           "",
           "What sets grow from: pairs of correspondences, or the paper's cliques of four.",
           0,
           0,
           {"pairs", "quadruples"}},
          HOMOLOG_FIELD(match.seeds)),
      row({"searched-points", "n", "", "Points of each shape that a match is searched from, those that answer strongest.", 8, 2000},
          HOMOLOG_FIELD(match.searched_points)),
      row({"partners", "k", "", "Partners by descriptor that each point keeps, both ways.", 1, 100}, HOMOLOG_FIELD(match.partners)),
      row({"bending", "tau", "model diagonals", "How far shapes may bend: rigid copies .003, posed bodies .015.", 0.0001, 1},
          HOMOLOG_FIELD(match.bending)),
      row({"mirror", "", "", "Whether a match may be a mirror image.", 0, 0, {"allow", "forbid", "only"}}, HOMOLOG_FIELD(match.mirror)),
      row({"matches", "n", "", "Most matches in the family; a search of two shapes keeps 16 at most.", 1, 100},
          HOMOLOG_FIELD(match.matches)),
  };
}

std::vector<Row> paper_rows() {
  return {
      row({"descriptor-limit", "t_d", "", "Largest descriptor distance of a candidate (eq. 7), in the descriptor's norm; 0: no limit.", 0,
           1000},
          HOMOLOG_FIELD(paper.descriptor_limit)),
      row({"pair-test",
           "w",
           "",
           "How two correspondences of a quadruple are compared (App. A): log of their proportions, or as printed.",
           0,
           0,
           {"proportions", "printed"}},
          HOMOLOG_FIELD(paper.pair_test)),
      row({"pair-tolerance", "t_w", "", "Two correspondences of a quadruple mismatch less than this (App. A).", 0.01, 10},
          HOMOLOG_FIELD(paper.pair_tolerance)),
      row({"direction-angle", "t_a", "radians", "Largest angle between a mapped direction and its partner in a quadruple (App. A).", 0.01,
           3.2},
          HOMOLOG_FIELD(paper.direction_angle)),
      row({"descriptor-spread", "sigma_d", "", "Descriptor distance at which a quadruple's score has fallen to exp(-1/2) (App. B).", 0.01,
           1000},
          HOMOLOG_FIELD(paper.descriptor_spread)),
      row({"condition-min", "t_k", "", "Smallest 1/k(A) of a quadruple's affine map, its least over its greatest stretch (App. B).", 0, 1},
          HOMOLOG_FIELD(paper.condition_min)),
      row({"bending-limit", "t_Delta", "r^3 energy at unit diagonal",
           "Most bending of a quadruple with one more correspondence (eq. 8, Sec. 6.2.2).", 0.001, 1e6},
          HOMOLOG_FIELD(paper.bending_limit)),
      row({"chamfer-limit", "t_c", "data diagonals", "Largest chamfer distance of the mapped, covered part of the model (eq. 9).", 0.0001,
           1},
          HOMOLOG_FIELD(paper.chamfer_limit)),
      row({"quadruples", "", "", "Most quadruples that are grown, best score first.", 1, 100000}, HOMOLOG_FIELD(paper.quadruples)),
  };
}

#undef HOMOLOG_FIELD

const std::vector<Row>& rows() {
  static const std::vector<Row> table = [] {
    std::vector<Row> all;
    for (const auto& some : {voxel_rows(), salient_rows(), descriptor_rows(), match_rows(), paper_rows()}) {
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return table;
}

const Row& find_row(const std::string& name) {
  for (const Row& row : rows()) {
    if (row.info.name == name) return row;
  }
  throw ParamError(fmt::format("unknown parameter '{}'; 'homolog params' lists all", name));
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
  params.paper.descriptor_limit = 1.6;  // the authors' 250 in our norm of |c_lm|
  params.paper.pair_test = PairTest::printed;
  params.paper.pair_tolerance = 0.4;
  params.paper.direction_angle = 0.3;
  params.paper.descriptor_spread = 1.6 * 130 / 250;  // sigma_d = 130
  return params;
}

Params preset(const std::string& name) {
  if (name == "default") return {};
  if (name == "paper") return paper_preset();
  throw ParamError(fmt::format("the preset '{}' is unknown; there are default and paper", name));
}

std::string range_text(const ParameterInfo& info) {
  if (info.choices.empty()) return fmt::format("{} to {}", info.min, info.max);
  std::string text = info.choices.front();
  for (std::size_t i = 1; i < info.choices.size(); ++i) text += (i + 1 == info.choices.size() ? " or " : ", ") + info.choices[i];
  return text;
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
