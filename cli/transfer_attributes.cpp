// SPDX-License-Identifier: MIT
#include "transfer_attributes.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "exit_codes.h"
#include "homolog/base/errors.h"
#include "homolog/match/carry_attributes.h"
#include "homolog/match/fill_places.h"
#include "homolog/outputs/attribute_files.h"
#include "homolog/outputs/write_file.h"
#include "homolog/shape/read_attributes.h"

namespace homolog::cli {
namespace {

/// The painted mesh, its fields of the kind that the user says.
AttributedMesh read_giver(const AttributeOptions& options, const ReadLimits& limits) {
  AttributedMesh giver = read_attributes(options.from, limits);
  for (const std::string& name : options.labels) {
    const auto field = std::find_if(giver.fields.begin(), giver.fields.end(), [&](const Field& f) { return f.name == name; });
    if (field == giver.fields.end()) {
      throw FileError(fmt::format("{}: it has no field '{}'; it has {}", options.from, name, told_attributes(giver)));
    }
    field->kind = Field::Kind::label;
  }
  return giver;
}

/// The places of the receiver's vertices on the giver.
DenseMap places_on(const AttributedMesh& giver, const Mesh& receiver, const MatchMap& match, Direction direction) {
  const bool forwards = direction == Direction::data_from_model;
  DenseMaps maps = dense_maps(match, forwards ? giver.mesh : receiver, forwards ? receiver : giver.mesh);
  return forwards ? std::move(maps.model_from_data) : std::move(maps.data_from_model);
}

/// How many triangles were textured; nothing if none could be.
std::string told_triangles(const Texturing& texturing) {
  if (texturing.uvs.empty()) return "";
  std::size_t count = 0;
  for (std::size_t t = 0; t < texturing.corners.size(); ++t) count += texturing.has_uvs(t);
  return fmt::format("{} of {} triangles have UVs\n", count, texturing.corners.size());
}

}  // namespace

void add_attribute_options(CLI::App& verb, AttributeOptions& options) {
  verb.add_option("--attributes", options.from,
                  fmt::format("What to carry is on this mesh, in the coordinates of the model: {}.", readable_attributes))
      ->type_name("FILE");
  verb.add_option("--onto", options.onto, "The mesh that receives it, in the coordinates of the data; else the one beside MATCH.")
      ->type_name("FILE");
  verb.add_option("--labels", options.labels, "Fields that hold labels although their numbers are not whole by type.")
      ->type_name("NAME")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  verb.add_flag("--fill", options.fill, "Leave no holes: what has no place gets what is nearest to where the match lays it.");
}

void check_options(const AttributeOptions& options, const std::string& out) {
  if (options.from.empty() && !options.onto.empty()) throw UsageError("--onto goes with --attributes");
  if (options.from.empty() && !options.labels.empty()) throw UsageError("--labels goes with --attributes");
  if (options.from.empty() && options.fill) throw UsageError("--fill goes with --attributes");
  if (!options.from.empty() && !writes_attributes(out)) {
    throw UsageError(fmt::format("attributes are written as {}, not as '{}'", writable_attributes, out));
  }
}

int transfer_attributes(const AttributeTransfer& transfer, const StoredFamily& family, const MatchMap& match, Console& console) {
  const bool forwards = transfer.direction == Direction::data_from_model;
  const AttributedMesh giver = read_giver(transfer.options, transfer.match.limits);
  const Mesh receiver = transfer.options.onto.empty() ? matched_mesh(transfer.match, "", forwards ? "data.part.ply" : "model.part.ply",
                                                                     forwards ? family.data.vertices : family.model.vertices)
                                                      : read_mesh(transfer.options.onto, transfer.match.limits);
  if (!family.parts_known) console.warn("no parts.json stands beside the match, so only distance tells which part is covered");
  console.stage("laying the meshes onto each other");
  DenseMap map = places_on(giver, receiver, match, transfer.direction);
  if (transfer.options.fill) {
    fill_places(map.places, receiver, giver.mesh, match, forwards ? Direction::model_from_data : Direction::data_from_model);
  }
  const AttributedMesh carried = carry_attributes(giver, receiver, map.places, chirality_of(match));
  for (const std::string& loss : attribute_losses(giver, transfer.out, transfer.options.from)) console.warn(loss);
  write_files(attribute_files(carried, map.places, transfer.out, std::filesystem::path(transfer.options.from).filename().string()));
  console.clear();
  const std::string to = transfer.options.onto.empty() ? (forwards ? family.data.file : family.model.file) : transfer.options.onto;
  print_result(fmt::format("{} carried from {} to {} of {} vertices of {}; {} {}: outside the covered part, or torn\n",
                           told_attributes(carried), transfer.options.from, map.placed, map.places.size(), to,
                           map.places.size() - map.placed, transfer.options.fill ? "are filled with what is nearest" : "have none") +
               told_triangles(carried.texturing));
  if (map.placed > 0) return kFound;
  print_message("nothing found: no vertex has a place on the other mesh; are the meshes those that were matched?");
  return kNothingFound;
}

}  // namespace homolog::cli
