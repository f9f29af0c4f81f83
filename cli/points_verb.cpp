// SPDX-License-Identifier: MIT
// homolog points SHAPE: the salient points alone.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "described_file.h"
#include "exit_codes.h"
#include "homolog/outputs/landmarks.h"
#include "homolog/outputs/match_json.h"
#include "homolog/outputs/report.h"
#include "options.h"
#include "result_folder.h"
#include "verbs.h"

namespace homolog::cli {
namespace {

struct PointsOptions {
  CommonOptions common;
  std::string shape;
  std::optional<Box> part;
  Label label;
};

constexpr const char* kExamples = R"(Examples:
  # The salient points of a bear as files, and as pictures in bear_points/report.html
  homolog points bear.off --out bear_points
  # Those of one part, as JSON
  homolog points bear.off --part "x=0.2..0.8,y>0.4" --json
  # Those that the paper's choices find
  homolog points bear.off --preset paper)";

/// As many digits as tell places within a shape apart that stands far from the origin.
int digits_for(const std::vector<Landmark>& landmarks, double diagonal) {
  double farthest = diagonal;
  for (const Landmark& landmark : landmarks) farthest = std::max(farthest, landmark.point.position.cwiseAbs().maxCoeff());
  return std::min(17, 5 + static_cast<int>(std::log10(farthest / diagonal)));
}

std::string points_table(const std::vector<Landmark>& landmarks, double diagonal) {
  if (landmarks.empty()) return "";
  const int digits = digits_for(landmarks, diagonal);
  std::string table = "label           x           y           z      radius  response\n";
  for (const auto& [label, point, confidence] : landmarks) {
    const Vec3& x = point.position;
    table += fmt::format("{:5}  {:10.{}g}  {:10.{}g}  {:10.{}g}  {:10.5g}  {:8.2f}\n", label, x.x(), digits, x.y(), digits, x.z(), digits,
                         point.radius, point.response);
  }
  return table;
}

int run_points(const PointsOptions& options) {
  const Params params = params_of(options.common);
  const ResultFolder folder(options.common.out, {options.shape});
  Console console(options.common.quiet, options.common.timing);
  const DescribedFile file = describe_file(options.shape, options.part, params, options.common.limits, console, options.label);

  console.stage("writing results");
  const auto landmarks = point_landmarks(file.shape);
  const std::string json = points_json(file.shape, params);
  if (folder.wanted()) {
    folder.write({{"points.json", whole(json)},
                  {"points.csv", whole(landmarks_csv(landmarks))},
                  {"points.mrk.json", whole(landmarks_markups(landmarks, file.shape.ras))},
                  {"report.html", whole(points_report(file.meshed(), params))}});
  }
  console.watch().lap("writing results", landmarks.size(), "points");
  console.clear();
  std::string text = options.common.json ? json : points_table(landmarks, file.shape.diagonal);
  if (folder.wanted() && !options.common.json) text += fmt::format("The report is {}\n", (folder / "report.html").string());
  print_result(text);
  if (!landmarks.empty()) return kFound;
  print_message(no_points(file.shape));
  return kNothingFound;
}

}  // namespace

Verb add_points(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("points", "Find the salient points of a shape.");
  const auto options = std::make_shared<PointsOptions>();
  verb->add_option("SHAPE", options->shape, fmt::format("The shape: {}.", kShapeHelp))->type_name("")->required();
  add_part_option(*verb, "--part", options->part);
  add_label_option(*verb, "--label", options->label);
  add_common_options(*verb, options->common);
  verb->footer(kExamples);
  return {verb, [options] { return run_points(*options); }};
}

}  // namespace homolog::cli
