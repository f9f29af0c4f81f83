// SPDX-License-Identifier: MIT
// homolog dense MATCH: for every vertex of either mesh its place on the other one, by a match found before.
#include <fmt/format.h>

#include <memory>

#include "console.h"
#include "exit_codes.h"
#include "homolog/base/parallel.h"
#include "homolog/outputs/dense_files.h"
#include "meshed_match.h"
#include "options.h"
#include "result_folder.h"
#include "verbs.h"

namespace homolog::cli {
namespace {

struct DenseOptions {
  MeshedMatchOptions meshed;
  std::string out;
};

constexpr const char* kExamples = R"(Examples:
  # Find one bear in the other, then every vertex of each on the other
  homolog match bear.off bear_bis.off --out bears
  homolog dense bears/match.json --out bears/dense
  # The second-best match
  homolog dense bears/match.json --match 2 --out second
  # A match of which nothing but match.json was kept: name the two meshes
  homolog dense match.json --model bear.off --data bear_bis.off --out dense

Written into the folder:
  data_from_model.csv   for every vertex of the model its place on the data: triangle, barycentric coordinates, x, y, z, confidence
  model_from_data.csv   for every vertex of the data its place on the model
  model.dense.ply       the model, coloured by position, with the places and the confidence (quality) as properties
  data.dense.ply        the data with the model's colours at the places: the same place has the same colour in both
  dense.json            how many vertices have a place, how many edges were torn, how many triangles are folded over
Rows of a vertex without a place, outside the covered part, are empty but for its number. Vertices and triangles are numbered from 0.)";

std::string told(const char* name, const std::string& from, const std::string& to, const DenseMap& map) {
  return fmt::format("{}: {} of {} vertices of {} have a place on {}; {} of {} triangles folded over, {} edges torn\n", name, map.placed,
                     map.places.size(), from, to, map.folded, map.triangles, map.torn);
}

void write_maps(const ResultFolder& folder, const MeshedMatch& laid, int match) {
  const auto& [family, model, data, maps] = laid;
  const std::vector<Colour> colours = position_colours(model);
  folder.write({{"data_from_model.csv", whole(dense_csv(maps.data_from_model))},
                {"model_from_data.csv", whole(dense_csv(maps.model_from_data))},
                {"model.dense.ply", whole(dense_ply(model, maps.data_from_model, colours))},
                {"data.dense.ply", whole(dense_ply(data, maps.model_from_data, carried_colours(maps.model_from_data, model, colours)))},
                {"dense.json", whole(dense_json(family, match, maps))}});
}

int run_dense(const DenseOptions& options) {
  const MeshedMatchOptions& given = options.meshed;
  const ResultFolder folder(options.out, {given.model, given.data});
  const ThreadLimit limit(parse_threads(given.threads));
  Console console(given.quiet, given.timing);
  const std::optional<MeshedMatch> laid = lay_meshed_match(given, console);
  if (!laid) return kNothingFound;
  const auto& [family, model, data, maps] = *laid;
  console.stage("writing results");
  write_maps(folder, *laid, given.match.number);
  console.watch().lap("writing results", model.vertices.size() + data.vertices.size(), "vertices");
  console.clear();
  print_result(told("data_from_model", family.model.file, family.data.file, maps.data_from_model) +
               told("model_from_data", family.data.file, family.model.file, maps.model_from_data));
  return outcome(maps);
}

}  // namespace

Verb add_dense(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("dense", "Find the place of every vertex on the other mesh by a match found before.");
  const auto options = std::make_shared<DenseOptions>();
  add_meshed_match_options(*verb, options->meshed);
  add_out_option(*verb, options->out)->required();
  verb->footer(kExamples);
  return {verb, [options] { return run_dense(*options); }};
}

}  // namespace homolog::cli
