// SPDX-License-Identifier: MIT
// homolog transfer MATCH: points and meshes carried from the model to the data, or back, by a match found before.
#include <fmt/format.h>

#include <memory>

#include "console.h"
#include "exit_codes.h"
#include "homolog/base/read_file.h"
#include "homolog/outputs/carried.h"
#include "homolog/outputs/read_points.h"
#include "homolog/outputs/write_file.h"
#include "homolog/shape/read_mesh.h"
#include "stored_match.h"
#include "verbs.h"

namespace homolog::cli {
namespace {

struct TransferOptions {
  StoredMatchOptions match;
  std::string points, mesh, out;
  bool inverse = false, quiet = false;
};

constexpr const char* kExamples = R"(Examples:
  # Find one bear in the other, then carry landmarks clicked on the first to the second
  homolog match bear.off bear_bis.off --out bears
  homolog transfer bears/match.json --points landmarks.csv --out carried.csv
  # The same for 3D Slicer, by the second-best match
  homolog transfer bears/match.json --points landmarks.mrk.json --match 2 --out carried.mrk.json
  # From the second bear back to the first
  homolog transfer bears/match.json --points carried.csv --inverse --out back.csv
  # The whole first bear in the shape of the second
  homolog transfer bears/match.json --mesh bear.off --out bent.ply

A point outside the part that the match covers is missing: its row stays, without coordinates ("undefined" in .mrk.json). Which part that
is stands in parts.json beside match.json. expected_error, in the unit of the shape carried to: true errors are larger as often as
smaller, if the match is right. In a .ply it is a property of the vertices beside quality, how surely they are covered.)";

enum class Kind { csv, markups, ply };

Kind kind_of(const std::string& out, bool mesh) {
  const std::string extension = lower_extension(out);
  if (mesh) {
    if (extension == ".ply") return Kind::ply;
    throw UsageError(fmt::format("a mesh is written as .ply, not as '{}'", out));
  }
  if (extension == ".csv") return Kind::csv;
  if (extension == ".json") return Kind::markups;
  throw UsageError(fmt::format("points are written as .csv or .mrk.json, not as '{}'", out));
}

std::vector<CarriedLandmark> carry_landmarks(const MatchMap& match, const std::vector<MarkupPoint>& points, Direction direction) {
  std::vector<Vec3> places;
  for (const MarkupPoint& point : points) {
    if (point.position) places.push_back(*point.position);
  }
  const std::vector<CarriedPoint> carried = carry_points(match, places, direction);
  std::vector<CarriedLandmark> landmarks;
  std::size_t next = 0;
  for (const MarkupPoint& point : points) {
    landmarks.push_back({point.label, point.position ? std::optional(carried[next++]) : std::nullopt});
  }
  return landmarks;
}

/// What was carried, as text for the file, and how many of how many are there.
struct Carried {
  std::string text;
  std::size_t there = 0, all = 0;
};

Carried carry_file(const MatchMap& match, const TransferOptions& options, Kind kind) {
  const Direction direction = options.inverse ? Direction::model_from_data : Direction::data_from_model;
  Carried result;
  if (kind == Kind::ply) {
    const Mesh mesh = read_mesh(options.mesh);
    const std::vector<CarriedPoint> vertices = carry_points(match, mesh.vertices, direction);
    for (const CarriedPoint& vertex : vertices) result.there += vertex.is_there();
    return {carried_ply(mesh, vertices), result.there, vertices.size()};
  }
  const auto landmarks = carry_landmarks(match, read_points(options.points), direction);
  for (const CarriedLandmark& landmark : landmarks) result.there += landmark.point && landmark.point->is_there();
  return {kind == Kind::csv ? carried_csv(landmarks) : carried_markups(landmarks), result.there, landmarks.size()};
}

int run_transfer(const TransferOptions& options) {
  if (options.points.empty() == options.mesh.empty()) throw UsageError("transfer needs either --points or --mesh");
  const Kind kind = kind_of(options.out, !options.mesh.empty());
  Console console(options.quiet, false);
  console.stage("reading the match");
  const StoredFamily family = read_family(options.match.file);
  if (family.matches.empty()) {
    print_message(fmt::format("nothing found: {} holds no match", options.match.file));
    return kNothingFound;
  }
  if (!family.parts_known) console.warn("no parts.json stands beside the match, so points outside the covered part are carried, too");
  const MatchMap& match = chosen_match(family, options.match);
  console.stage("carrying");
  const Carried carried = carry_file(match, options, kind);
  write_file(options.out, carried.text);
  console.clear();
  const std::string& from = options.inverse ? family.data_file : family.model_file;
  const std::string& to = options.inverse ? family.model_file : family.data_file;
  print_result(fmt::format("{} of {} {} carried from {} to {}; {} outside the covered part\n", carried.there, carried.all,
                           kind == Kind::ply ? "vertices" : "points", from, to, carried.all - carried.there));
  if (carried.there > 0) return kFound;
  print_message(fmt::format("nothing found: no point lies in the part that match {} covers; are the points those of {}?",
                            options.match.number, from));
  return kNothingFound;
}

}  // namespace

Verb add_transfer(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("transfer", "Carry points or a mesh from the model to the data by a match found before.");
  const auto options = std::make_shared<TransferOptions>();
  add_stored_match_options(*verb, options->match);
  verb->add_option("--points", options->points, "Points to carry: .csv with the columns x, y, z (and label), or .mrk.json.")
      ->type_name("FILE");
  verb->add_option("--mesh", options->mesh, "A mesh to carry, in the coordinates of the model.")->type_name("FILE");
  verb->add_option("--out", options->out, "Where to write: .csv or .mrk.json for points, .ply for a mesh.")->type_name("FILE")->required();
  verb->add_flag("--inverse", options->inverse, "Carry from the data to the model.");
  verb->add_flag("--quiet", options->quiet, "No progress and no warnings.");
  verb->footer(kExamples);
  return {verb, [options] { return run_transfer(*options); }};
}

}  // namespace homolog::cli
