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
#include "meshed_match.h"
#include "options.h"
#include "verbs.h"
#include "whole_number.h"

namespace homolog::cli {
namespace {

struct MorphOptions {
  MeshedMatchOptions meshed;
  std::string out;
  int frames = 0;  ///< meshes besides, none or from 2 to most_frames
  bool coloured = false;
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

void check_out(const std::string& out) {
  if (lower_extension(out) != ".glb") throw UsageError(fmt::format("a morph is written as .glb, not as '{}'", out));
}

int run_morph(const MorphOptions& options) {
  check_out(options.out);
  const MeshedMatchOptions& given = options.meshed;
  const ThreadLimit limit(parse_threads(given.threads));
  Console console(given.quiet, given.timing);
  const std::optional<MeshedMatch> laid = lay_meshed_match(given, console);
  if (!laid) return kNothingFound;
  const auto& [family, model, data, maps] = *laid;
  console.stage("writing results");
  std::vector<std::filesystem::path> read = stored_files(given.match);
  read.insert(read.end(), {given.model, given.data});
  write_files(morph_files(make_morph(chosen_match(family, given.match), model, maps), options), read);
  console.watch().lap("writing results", 1 + static_cast<std::size_t>(options.frames), "files");
  console.clear();
  const DenseMap& map = maps.data_from_model;
  print_result(fmt::format("{} turns into {}: {} of {} vertices have a place there; {} of {} triangles folded over, {} edges torn\n",
                           family.model.file, family.data.file, map.placed, model.vertices.size(), map.folded, map.triangles, map.torn));
  return outcome(maps);
}

}  // namespace

Verb add_morph(CLI::App& program) {
  CLI::App* verb = program.add_subcommand("morph", "Turn the model into the data by a match found before, as an animated glTF.");
  const auto options = std::make_shared<MorphOptions>();
  add_meshed_match_options(*verb, options->meshed);
  verb->add_option("--out", options->out, "Where to write: a .glb.")->type_name("FILE")->required();
  const auto store = [options](const std::string& text) {
    options->frames = static_cast<int>(whole_number("--frames", text, 2, most_frames));
  };
  verb->add_option_function<std::string>("--frames", store, "Write so many meshes besides, from the model to the data.")->type_name("N");
  verb->add_flag("--colour", options->coloured, "Colour the vertices by their position on the model.");
  verb->footer(kExamples);
  return {verb, [options] { return run_morph(*options); }};
}

}  // namespace homolog::cli
