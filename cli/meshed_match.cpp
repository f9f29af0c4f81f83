// SPDX-License-Identifier: MIT
#include "meshed_match.h"

#include "exit_codes.h"
#include "options.h"

namespace homolog::cli {

void add_meshed_match_options(CLI::App& verb, MeshedMatchOptions& options) {
  add_stored_match_options(verb, options.match);
  verb.add_option("--model", options.model, "The model that was matched; else the one beside MATCH.")->type_name("FILE");
  verb.add_option("--data", options.data, "The data that was matched; else the one beside MATCH.")->type_name("FILE");
  add_threads_option(verb, options.threads);
  verb.add_flag("--quiet", options.quiet, "No progress and no warnings.");
  add_timing_option(verb, options.timing);
}

std::optional<MeshedMatch> lay_meshed_match(const MeshedMatchOptions& options, Console& console) {
  console.stage("reading the match");
  std::optional<StoredFamily> found = read_matches(options.match);
  if (!found) return {};
  MeshedMatch read{std::move(*found), {}, {}, {}};
  const MatchMap& match = chosen_match(read.family, options.match);
  read.model = matched_mesh(options.match, options.model, read.family, match, Direction::data_from_model);
  read.data = matched_mesh(options.match, options.data, read.family, match, Direction::model_from_data);
  warn_of_doubt(read.family, match, console);
  console.watch().lap("reading match and meshes", read.model.triangles.size() + read.data.triangles.size(), "triangles");
  console.stage("laying the meshes onto each other");
  read.maps = dense_maps(match, read.model, read.data);
  console.watch().lap("dense maps", read.model.vertices.size() + read.data.vertices.size(), "vertices");
  return read;
}

int outcome(const DenseMaps& maps) {
  if (maps.data_from_model.placed > 0) return kFound;
  print_message("nothing found: no vertex has a place; are the meshes those that were matched?");
  return kNothingFound;
}

}  // namespace homolog::cli
