// SPDX-License-Identifier: MIT
#include "transfer_attributes.h"

#include <fmt/format.h>

#include "exit_codes.h"
#include "homolog/outputs/attribute_files.h"
#include "homolog/shape/read_attributes.h"
#include "homolog/shape/read_mesh.h"

namespace homolog::cli {
namespace {

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

int transfer_attributes(const AttributeTransfer& transfer, const std::string& onto, const StoredMatchOptions& options,
                        const StoredFamily& family, const MatchMap& match, Console& console) {
  const bool forwards = transfer.direction == Direction::data_from_model;
  const StoredShape &from = forwards ? family.model : family.data, &to = forwards ? family.data : family.model;
  const Direction back = forwards ? Direction::model_from_data : Direction::data_from_model;
  const Mesh receiver =
      onto.empty() ? stored_mesh(options, "", family, back) : read_mesh(onto, options.limits, {}, warnings_of(onto, console));
  console.stage("laying the meshes onto each other");
  const std::string name = onto.empty() ? to.file : onto;
  const TransferredAttributes carried = transfer_attributes(transfer, match, {receiver, name}, {from.file, to.file});
  console.watch().lap("laying, carrying and writing", receiver.vertices.size(), "vertices");
  for (const std::string& loss : carried.losses) console.warn(loss);
  console.clear();
  const std::size_t count = receiver.vertices.size();
  print_result(fmt::format("{} carried from {} to {} of {} vertices of {}; {} {}: outside the covered part, or torn\n",
                           told_attributes(carried.mesh), transfer.from.string(), carried.placed, count, name, count - carried.placed,
                           transfer.fill ? "are filled with what is nearest" : "have none") +
               told_triangles(carried.mesh.texturing));
  if (carried.placed > 0) return kFound;
  print_message("nothing found: no vertex has a place on the other mesh; are the meshes those that were matched?");
  return kNothingFound;
}

}  // namespace homolog::cli
