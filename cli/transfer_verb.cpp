// SPDX-License-Identifier: MIT
// homolog transfer MATCH: points and meshes carried from the model to the data, or back, by a match found before.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "console.h"
#include "exit_codes.h"
#include "homolog/base/errors.h"
#include "homolog/base/parallel.h"
#include "homolog/base/read_file.h"
#include "homolog/outputs/attribute_files.h"
#include "homolog/outputs/carried.h"
#include "homolog/outputs/misplaced.h"
#include "homolog/outputs/read_points.h"
#include "homolog/outputs/write_file.h"
#include "homolog/outputs/write_points.h"
#include "homolog/shape/read_mesh.h"
#include "homolog/shape/text.h"
#include "options.h"
#include "stored_match.h"
#include "transfer_attributes.h"
#include "verbs.h"

namespace homolog::cli {
namespace {

struct TransferOptions {
  StoredMatchOptions match;
  std::string points, specimen, mesh, out, threads = "0";
  AttributeOptions attributes;
  bool inverse = false, quiet = false, timing = false;
};

constexpr const char* kExamples = R"(Examples:
  # Find one bear in the other, then carry landmarks clicked on the first to the second
  homolog match bear.off bear_bis.off --out bears
  homolog transfer bears/match.json --points landmarks.csv --out carried.csv
  # The same for 3D Slicer, by the second-best match
  homolog transfer bears/match.json --points landmarks.mrk.json --match 2 --out carried.mrk.json
  # One specimen of a collection, for R (.pts of Landmark Editor and .txt of Morphologika go the same way)
  homolog transfer bears/match.json --points collection.tps --specimen bear --out carried.tps
  # From the second bear back to the first
  homolog transfer bears/match.json --points carried.csv --inverse --out back.csv
  # The whole first bear in the shape of the second
  homolog transfer bears/match.json --mesh bear.off --out bent.ply
  # The colours, values and labels of a painted copy of the first bear, onto the mesh of the second
  homolog transfer bears/match.json --attributes painted.ply --onto bear_bis.off --out painted_bis.ply
  # The same without holes (what has no place gets what is nearest), its field 'part' taken for labels
  homolog transfer bears/match.json --attributes painted.ply --onto bear_bis.off --fill --labels part --out filled_bis.ply
  # Its UVs and materials, onto the mesh beside the match: the .obj, its .mtl and its pictures
  homolog transfer bears/match.json --attributes painted.obj --out painted_bis.obj
  # All that a rigged .glb holds: materials, skin weights with the skeleton, shape keys
  homolog transfer bears/match.json --attributes rigged.glb --out rigged_bis.glb

A point outside the part that the match covers is missing: its row stays, without coordinates ("undefined" in .mrk.json, NA in .tps and .txt,
9999 in .pts). Which part that is stands in parts.json beside match.json. Points of .mrk.json and .fcsv are taken to LPS, whichever system
the file states, or to RAS where the mesh was saved so by 3D Slicer (SPACE=RAS). expected_error, in the unit of the shape carried to: true errors are larger as often as smaller, if the match is right. It
stands in a column of .csv beside coverage, in the descriptions of .mrk.json, and in a .ply as a property of the vertices beside quality, how
surely they are covered; .tps, .pts and .txt hold places alone.

--attributes looks up every vertex of the receiving mesh on the painted one ('homolog dense'): colours and values lie between those of the
triangle's corners, a label is the nearest corner's, and a triangle lies on the UV island that its middle lies on, so seams stay seams. What
has no place there is told and counted: in a .ply its property 'carried' is 0, in an .obj its material is 'not_carried', in a .glb it has
none; --fill leaves nothing so marked. The skeleton is carried in the pose in which the mesh was bound to it; joints turn and move with the
surface about them, and keep their names. Shape keys turn and scale with it. What has no place follows the joints of the nearest that has,
and keys fade there. Joints turn in their parents as the giver's do over time, so animations show the giver's poses.

Meshes must lie where the shapes lay when they were matched, with the same axes and unit: others are refused. Parts of the shape, more than
was matched of it, and other tessellations are welcome; --mesh carries what lies inside, too.)";

/// Throws UsageError for a file that cannot be written, and when it is not said what to carry.
void check_options(const TransferOptions& options) {
  const int given = !options.points.empty() + !options.mesh.empty() + !options.attributes.from.empty();
  if (given != 1) throw UsageError("transfer needs either --points or --mesh or --attributes");
  if (options.points.empty() && !options.specimen.empty()) throw UsageError("--specimen goes with --points");
  check_options(options.attributes, options.out);
  if (!options.points.empty() && !writes_points(options.out)) {
    throw UsageError(fmt::format("points are written as {}, not as '{}'", writable_points, options.out));
  }
  if (!options.mesh.empty() && lower_extension(options.out) != ".ply")
    throw UsageError(fmt::format("a mesh is written as .ply, not as '{}'", options.out));
}

/// The markups of the file that points are from, if it is one of these and they are written as such.
std::vector<MarkupList> lists_of(const TransferOptions& options, Console& console) {
  if (lower_extension(options.points) != ".json") return {};
  const std::vector<MarkupList> lists = read_markup_lists(read_file(options.points), options.points);
  const bool kept = lower_extension(options.out) == ".json";
  for (const MarkupList& list : lists) {
    const std::string& type = list.dropped.empty() ? list.type : list.dropped;
    if (list.dropped.empty() && (kept || (type == "Fiducial" && lists.size() == 1))) continue;
    console.warn(
        fmt::format("{}: what it holds is written as plain points{}", options.points,
                    kept ? fmt::format(", not as {}", shown(type)) : ", one list after the other; a .mrk.json holds lists and curves"));
    break;
  }
  return kept ? lists : std::vector<MarkupList>{};
}

/// Throws FileError for what no file may hold; of `given`, the file carried from, and `match`, one is to blame.
void check_finite(const std::vector<CarriedPoint>& points, bool only_there, const std::string& given, const std::string& match) {
  for (const CarriedPoint& point : points) {
    if (is_finite(point) || (only_there && !point.is_there())) continue;
    throw FileError(fmt::format("{}: the match leads a point of {} to no finite place; name a sound match.json and points near its shapes",
                                match, given));
  }
}

/// Of those that have one.
std::vector<Vec3> places_of(const std::vector<MarkupPoint>& points) {
  std::vector<Vec3> places;
  for (const MarkupPoint& point : points) {
    if (point.position) places.push_back(*point.position);
  }
  return places;
}

std::vector<CarriedLandmark> carry_landmarks(const MatchMap& match, const std::vector<MarkupPoint>& points, Direction direction,
                                             const TransferOptions& options) {
  const std::vector<CarriedPoint> carried = carry_points(match, places_of(points), direction);
  check_finite(carried, true, options.points, options.match.file);
  std::vector<CarriedLandmark> landmarks;
  std::size_t next = 0;
  for (const MarkupPoint& point : points) {
    landmarks.push_back({point.label, point.position ? std::optional(carried[next++]) : std::nullopt, point.description, point.display});
  }
  return landmarks;
}

/// What was carried, as text for the file, and how many of how many are there; missing ones were so in the file carried from, and for
/// folded ones the map has no inverse.
struct Carried {
  std::string text;
  std::size_t there = 0, all = 0, missing = 0, folded = 0;

  void count(const std::optional<CarriedPoint>& point) {
    ++all;
    there += point && point->is_there();
    missing += !point;
    folded += point && point->is_covered() && !point->exact;
  }

  std::string told(const char* what, const std::string& from, const std::string& to) const {
    const auto others = [](std::size_t n, const char* why) { return n > 0 ? fmt::format(", {} {}", n, why) : ""; };
    return fmt::format("{} of {} {} carried from {} to {}; {} outside the covered part{}{}\n", there, all, what, from, to,
                       all - there - missing - folded, others(folded, "where the map folds"), others(missing, "missing before"));
  }
};

/// A mesh need not be the one that was matched: one of what lies inside or beside it is carried, too, but not one that is known to be
/// turned.
Carried carry_mesh(const MatchMap& match, const TransferOptions& options, const MatchedShape& shape, Direction direction,
                   Console& console) {
  Mesh mesh = read_mesh(options.mesh, options.match.limits, {}, warnings_of(options.mesh, console));
  if (const auto wrong = misplaced(mesh, options.mesh, shape)) {
    if (wrong->explained) throw FileError(wrong->sentence);
    console.warn(wrong->sentence);
  }
  const std::vector<CarriedPoint> vertices = carry_points(match, mesh.vertices, direction);
  check_finite(vertices, false, options.mesh, options.match.file);
  mesh.triangles = carried_triangles(match, mesh);
  Carried result{carried_ply(mesh, vertices)};
  for (const CarriedPoint& vertex : vertices) result.count(vertex);
  return result;
}

void warn_of_misplaced_points(const std::vector<MarkupPoint>& points, const std::string& file, const MatchedShape& shape,
                              Console& console) {
  if (const std::string asked = misplaced_points(places_of(points), file, shape); !asked.empty()) console.warn(asked);
}

Carried carry_file(const MatchMap& match, const TransferOptions& options, const StoredShape& from, const StoredShape& to,
                   Direction direction, Console& console) {
  const MatchedShape shape = carried_from(match, direction, from.file);
  if (!options.mesh.empty()) return carry_mesh(match, options, shape, direction, console);
  const std::vector<MarkupPoint> points = read_points(options.points, options.specimen, from.ras);
  if (points.empty()) throw FileError(fmt::format("{}: it holds no points; name the file with the landmarks to carry", options.points));
  warn_of_misplaced_points(points, options.points, shape, console);
  const auto landmarks = carry_landmarks(match, points, direction, options);
  const std::string specimen = std::filesystem::path(to.file).stem().string();
  Carried result{points_text(landmarks, options.out, specimen, to.ras, lists_of(options, console))};
  for (const CarriedLandmark& landmark : landmarks) result.count(landmark.point);
  return result;
}

/// That are read and must not be overwritten.
std::vector<std::filesystem::path> files_of(const TransferOptions& options) {
  std::vector<std::filesystem::path> files = stored_files(options.match);
  files.insert(files.end(), {options.points, options.mesh, options.attributes.onto});
  return files;
}

int run_transfer(const TransferOptions& options) {
  check_options(options);
  const ThreadLimit limit(parse_threads(options.threads));
  Console console(options.quiet, options.timing);
  console.stage("reading the match");
  const std::optional<StoredFamily> found = read_matches(options.match);
  if (!found) return kNothingFound;
  const StoredFamily& family = *found;
  const MatchMap& match = chosen_match(family, options.match);
  warn_of_doubt(family, match, console);
  console.watch().lap("reading the match", family.matches.size(), "matches");
  const Direction direction = options.inverse ? Direction::model_from_data : Direction::data_from_model;
  if (const AttributeOptions& given = options.attributes; !given.from.empty()) {
    return transfer_attributes({given.from, options.out, direction, given.labels, given.fill, options.match.limits, files_of(options)},
                               given.onto, options.match, family, match, console);
  }
  const StoredShape& from = options.inverse ? family.data : family.model;
  const StoredShape& to = options.inverse ? family.model : family.data;
  console.stage("carrying");
  const Carried carried = carry_file(match, options, from, to, direction, console);
  console.watch().lap("carrying", carried.all, options.mesh.empty() ? "points" : "vertices");
  write_files(std::vector<OutputFile>{{options.out, carried.text}}, files_of(options));
  console.watch().lap("writing results", carried.text.size(), "bytes");
  console.clear();
  print_result(carried.told(options.mesh.empty() ? "points" : "vertices", from.file, to.file));
  if (carried.there > 0) return kFound;
  print_message(fmt::format("nothing found: no point lies in the part that match {} covers; are the points those of {}?",
                            options.match.number, from.file));
  return kNothingFound;
}

}  // namespace

Verb add_transfer(CLI::App& program) {
  CLI::App* verb = program.add_subcommand(
      "transfer", "Carry points, a mesh, or what is painted on one, from the model to the data by a match found before.");
  const auto options = std::make_shared<TransferOptions>();
  add_stored_match_options(*verb, options->match);
  verb->add_option("--points", options->points, fmt::format("Points to carry: {}.", readable_points))->type_name("FILE");
  verb->add_option("--specimen", options->specimen, "Which one of a .tps or .txt that holds several: its name, or its number from 1.")
      ->type_name("NAME");
  verb->add_option("--mesh", options->mesh, "A mesh to carry, in the coordinates of the model.")->type_name("FILE");
  add_attribute_options(*verb, options->attributes);
  verb->add_option("--out", options->out,
                   fmt::format("Where to write: {} for points, .ply for a mesh, {} for attributes.", writable_points, writable_attributes))
      ->type_name("FILE")
      ->required();
  verb->add_flag("--inverse", options->inverse, "Carry from the data to the model.");
  add_threads_option(*verb, options->threads);
  verb->add_flag("--quiet", options->quiet, "No progress and no warnings.");
  add_timing_option(*verb, options->timing);
  verb->footer(kExamples);
  return {verb, [options] { return run_transfer(*options); }};
}

}  // namespace homolog::cli
