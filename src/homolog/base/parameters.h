// SPDX-License-Identifier: MIT
// Every parameter of the program: one struct per stage holds the defaults, one table says the rest (symbol, range, unit, sentence).
// CLI flags, JSON, checks and the docs page all come from that table. No length is metric: all are relative to the shape or to r.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace homolog {

enum class Mirror { allow, forbid, only };
enum class DescriptorKind { free, axial };  ///< |c_l| without a frame, |c_lm| about p (Sec. 5.2)
enum class Shells { logarithmic, linear };
enum class Seeds { pairs, quadruples };  ///< pairs of correspondences, or the paper's cliques of four (App. A, B)

struct VoxelParams {
  int resolution = 224;
  double thicken = 0;
};

struct SalientParams {
  double sigma0 = 1.6;
  int levels_per_octave = 3;
  double threshold = 0.45;
  double direction_radius = 2;
  double direction_min = 0.12;
};

struct DescriptorParams {
  DescriptorKind kind = DescriptorKind::free;
  Shells shells = Shells::logarithmic;
  int shell_count = 8;
  int degree = 8;
  double inner = 0.5;
  double outer = 8;
};

struct MatchParams {
  Seeds seeds = Seeds::pairs;
  int searched_points = 100;
  int partners = 10;
  double bending = 0.015;
  Mirror mirror = Mirror::allow;
  int matches = 12;
};

enum class PairTest { proportions, printed };  ///< see pair_mismatch in match/quadruples.h

/// What grows from quadruples (Sec. 6.2, App. A and B) needs. These defaults find sets under pose; paper_preset() has the printed ones.
struct PaperParams {
  double descriptor_limit = 0;
  PairTest pair_test = PairTest::proportions;
  double pair_tolerance = 0.25;
  double direction_angle = 0.6;
  double descriptor_spread = 2.5;
  double condition_min = 0.15;
  double bending_limit = 25;
  double chamfer_limit = 0.03;
  int quadruples = 500;
};

struct Params {
  VoxelParams voxel;
  SalientParams salient;
  DescriptorParams descriptor;
  MatchParams match;
  PaperParams paper;
  int threads = 0;
};

/// The paper's choices, with its equations corrected (docs/paper_map.md).
Params paper_preset();

/// By name: default or paper. Throws ParamError.
Params preset(const std::string& name);

/// One row of the parameter table.
struct ParameterInfo {
  std::string name, symbol, unit, sentence;
  double min, max;                        ///< range of a number
  std::vector<std::string> choices = {};  ///< the words of a choice; empty for numbers
  bool integer = false;
};

using ParameterValue = std::variant<long, double, std::string>;

/// All parameters, in the order in which outputs list them.
const std::vector<ParameterInfo>& parameter_table();

/// The value of a parameter by its name. Throws ParamError for an unknown name.
ParameterValue get_parameter(const Params& params, const std::string& name);

/// The range of a parameter in words: "32 to 1024", "allow, forbid or only".
std::string range_text(const ParameterInfo& info);

/// Sets a parameter from text. Throws ParamError for an unknown name, a malformed value or one out of range.
void set_parameter(Params& params, const std::string& name, const std::string& value);

/// A value as text: numbers shortest, so that reading gives the same number back.
std::string to_text(const ParameterValue& value);

/// Throws ParamError for the first value out of its range.
void check(const Params& params);

}  // namespace homolog
