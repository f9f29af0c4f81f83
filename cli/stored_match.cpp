// SPDX-License-Identifier: MIT
#include "stored_match.h"

#include <fmt/format.h>

#include <filesystem>
#include <limits>

#include "exit_codes.h"
#include "homolog/base/errors.h"
#include "homolog/outputs/doubt.h"
#include "homolog/outputs/misplaced.h"
#include "homolog/shape/read_mesh.h"
#include "input_limits.h"
#include "whole_number.h"

namespace homolog::cli {
namespace {

std::filesystem::path path_beside(const StoredMatchOptions& options, bool is_model) {
  return std::filesystem::path(options.file).parent_path() / (is_model ? "model.part.ply" : "data.part.ply");
}

}  // namespace

void add_stored_match_options(CLI::App& verb, StoredMatchOptions& options) {
  verb.add_option("MATCH", options.file, "The match.json that 'homolog match --out' wrote.")->type_name("")->required();
  const auto store = [&number = options.number](const std::string& text) {
    number = static_cast<int>(whole_number("--match", text, 1, std::numeric_limits<int>::max()));
  };
  verb.add_option_function<std::string>("--match", store, "Which match, 1 for the best.")->type_name("N");
  add_reading_limits(verb, options.limits);
}

std::vector<std::filesystem::path> stored_files(const StoredMatchOptions& options) {
  return {options.file, std::filesystem::path(options.file).replace_filename("parts.json"), path_beside(options, true),
          path_beside(options, false)};
}

std::optional<StoredFamily> read_matches(const StoredMatchOptions& options) {
  StoredFamily family = read_family(options.file);
  if (!family.matches.empty()) return family;
  print_message(fmt::format("nothing found: {} holds no match; match the shapes again, with a higher --resolution, say", options.file));
  return {};
}

const MatchMap& chosen_match(const StoredFamily& family, const StoredMatchOptions& options) {
  const auto count = static_cast<int>(family.matches.size());
  if (options.number > count) {
    throw UsageError(fmt::format("--match is {}, but {} holds {} match{}; choose 1{}", options.number, options.file, count,
                                 count == 1 ? "" : "es", count == 1 ? "" : fmt::format(" to {}", count)));
  }
  return family.matches[static_cast<std::size_t>(options.number - 1)];
}

void warn_of_doubt(const StoredFamily& family, const MatchMap& match, Console& console) {
  if (!family.parts_known) console.warn("no parts.json stands beside the match, so nothing is known to lie outside the covered part");
  if (const std::string doubt = doubt_of_match(match.confidence); !doubt.empty()) console.warn(doubt);
}

Mesh stored_mesh(const StoredMatchOptions& options, const std::string& given, const StoredFamily& family, Direction direction) {
  const bool is_model = direction == Direction::data_from_model;
  const StoredShape& shape = is_model ? family.model : family.data;
  const std::filesystem::path path = given.empty() ? path_beside(options, is_model) : std::filesystem::path(given);
  if (given.empty() && !std::filesystem::exists(path)) {
    throw FileError(fmt::format("{}: this mesh does not stand beside the match; name the meshes that were matched by --model and --data",
                                path.string()));
  }
  const StoredShape& other = is_model ? family.data : family.model;
  if (other.file != shape.file && path.filename() == other.file) {
    throw FileError(fmt::format("{}: it was the {} of this match, not the {}; exchange --model and --data", path.string(),
                                is_model ? "data" : "model", is_model ? "model" : "data"));
  }
  Mesh mesh = read_mesh(path, options.limits);
  if (shape.vertices != 0 && mesh.vertices.size() != shape.vertices) {
    throw FileError(fmt::format("{}: it has {} vertices, but the mesh that was matched had {}; name that one", path.string(),
                                mesh.vertices.size(), shape.vertices));
  }
  return mesh;
}

Mesh matched_mesh(const StoredMatchOptions& options, const std::string& given, const StoredFamily& family, const MatchMap& match,
                  Direction direction) {
  const bool is_model = direction == Direction::data_from_model;
  Mesh mesh = stored_mesh(options, given, family, direction);
  const std::string& name = is_model ? family.model.file : family.data.file;
  const std::string file = given.empty() ? path_beside(options, is_model).string() : given;
  if (const auto wrong = misplaced(mesh, file, carried_from(match, direction, name))) throw FileError(wrong->sentence);
  return mesh;
}

}  // namespace homolog::cli
