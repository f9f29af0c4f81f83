// SPDX-License-Identifier: MIT
// homolog morph MATCH: the model turning into the data, as an animated glTF and as single meshes.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "console.h"
#include "exit_codes.h"
#include "homolog/base/parallel.h"
#include "homolog/base/read_file.h"
#include "homolog/outputs/dense_files.h"
#include "homolog/outputs/morph.h"
#include "homolog/outputs/write_file.h"
#include "options.h"
#include "stored_match.h"
#include "verbs.h"

namespace homolog::cli {
namespace {

struct MorphOptions {
  StoredMatchOptions match;
  std::string model, data, out, threads = "0";
  int frames = 0;
  bool coloured = false, quiet = false, timing = false;
};

constexpr int most_frames = 1000;

constexpr const char* kExamples = R"(Examples:
  # One bear that turns into the other: opens in any glTF viewer
  homolog match bear.off bear_bis.off --out bears
  homolog morph bears/match.json --out morph.glb
  # Coloured by position, and ten meshes besides: morph.01.ply is the model, morph.10.ply lies on the data
  homolog morph bears/match.json --colour --frames 10 --out morph.glb

The mesh is the model's, its vertices in their order, laid over the data by the similarity of the match; the morph target 'data' has every
vertex at its place on the data ('homolog dense'). What has no place there is carried along smoothly. Axes and unit are the data's.)";

/// morph.glb, 3 of 10: morph.03.ply
std::filesystem::path frame_path(const std::filesystem::path& out, int number, int count) {
  const auto width = std::to_string(count).size();
  return out.parent_path() / fmt::format("{}.{:0{}}.ply", out.stem().string(), number, width);
}

std::vector<OutputFile> morph_files(const Morph& morph, const MorphOptions& options) {
  const std::vector<Colour> colours = options.coloured ? position_colours(morph.start) : std::vector<Colour>{};
  std::vector<OutputFile> files{{options.out, morph_glb(morph, colours)}};
  for (int i = 0; i < options.frames; ++i) {
    const Mesh frame = frame_of(morph, static_cast<double>(i) / (options.frames - 1));
    files.push_back({frame_path(options.out, i + 1, options.frames),
                     ply_text(frame, colours, {}, fmt::format("frame {} of {}", i + 1, options.frames))});
  }
  return files;
}

void check_options(const MorphOptions& options) {
  if (lower_extension(options.out) != ".glb") throw UsageError(fmt::format("a morph is written as .glb, not as '{}'", options.out));
  if (options.frames == 0 || (options.frames >= 2 && options.frames <= most_frames)) return;
  throw UsageError(fmt::format("--frames is {}, but must be a whole number from 2 to {}", options.frames, most_frames));
}

int run_morph(const MorphOptions& options) {
  check_options(options);
  const ThreadLimit limit(parse_threads(options.threads));
  Console console(options.quiet, options.timing);
  console.stage("reading the match");
  const std::optional<StoredFamily> found = read_matches(options.match);
  if (!found) return kNothingFound;
  const StoredFamily& family = *found;
  const MatchMap& match = chosen_match(family, options.match);
  const Mesh model = matched_mesh(options.match, options.model, family, match, Direction::data_from_model);
  const Mesh data = matched_mesh(options.match, options.data, family, match, Direction::model_from_data);
  console.stage("laying the model onto the data");
  console.watch().lap("reading match and meshes", model.triangles.size() + data.triangles.size(), "triangles");
  const DenseMaps maps = dense_maps(match, model, data);
  console.watch().lap("dense maps", model.vertices.size() + data.vertices.size(), "vertices");
  console.stage("writing results");
  std::vector<std::filesystem::path> read = stored_files(options.match);
  read.insert(read.end(), {options.model, options.data});
  write_files(morph_files(make_morph(match, model, maps), options), read);
  console.watch().lap("writing results", 1 + static_cast<std::size_t>(options.frames), "files");
  console.clear();
  const DenseMap& map = maps.data_from_model;
  print_result(fmt::format("{} turns into {}: {} of {} vertices have a place there; {} of {} triangles folded over, {} edges torn\n",
                           family.model.file, family.data.file, map.placed, model.vertices.size(), map.folded, map.triangles, map.torn));
  return kFound;
}

}  // namespace

Verb add_morph(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("morph", "Turn the model into the data by a match found before, as an animated glTF.");
  const auto options = std::make_shared<MorphOptions>();
  add_stored_match_options(*verb, options->match);
  verb->add_option("--out", options->out, "Where to write: a .glb.")->type_name("FILE")->required();
  verb->add_option("--frames", options->frames, "Write so many meshes besides, from the model to the data.")->type_name("N");
  verb->add_flag("--colour", options->coloured, "Colour the vertices by their position on the model.");
  verb->add_option("--model", options->model, "The model that was matched; else the one beside MATCH.")->type_name("FILE");
  verb->add_option("--data", options->data, "The data that was matched; else the one beside MATCH.")->type_name("FILE");
  add_threads_option(*verb, options->threads);
  verb->add_flag("--quiet", options->quiet, "No progress and no warnings.");
  add_timing_option(*verb, options->timing);
  verb->footer(kExamples);
  return {verb, [options] { return run_morph(*options); }};
}

}  // namespace homolog::cli
