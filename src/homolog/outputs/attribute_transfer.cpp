// SPDX-License-Identifier: MIT
#include "homolog/outputs/attribute_transfer.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "homolog/base/errors.h"
#include "homolog/match/carry_attributes.h"
#include "homolog/match/fill_places.h"
#include "homolog/outputs/attribute_files.h"
#include "homolog/outputs/misplaced.h"
#include "homolog/outputs/write_file.h"
#include "homolog/shape/read_attributes.h"

namespace homolog {
namespace {

/// The painted mesh, its fields of the kind that the user says.
AttributedMesh read_giver(const AttributeTransfer& transfer) {
  AttributedMesh giver = read_attributes(transfer.from, transfer.limits);
  for (const std::string& name : transfer.labels) {
    const auto field = std::find_if(giver.fields.begin(), giver.fields.end(), [&](const Field& f) { return f.name == name; });
    if (field == giver.fields.end()) {
      throw FileError(fmt::format("{}: it has no field '{}'; it has {}", transfer.from.string(), name, told_attributes(giver)));
    }
    field->kind = Field::Kind::label;
  }
  return giver;
}

void refuse_misplaced(const Mesh& mesh, const std::string& file, const MatchedShape& shape) {
  if (const auto wrong = misplaced(mesh, file, shape)) throw FileError(wrong->sentence);
}

}  // namespace

TransferredAttributes transfer_attributes(const AttributeTransfer& transfer, const MatchMap& match, const Receiver& receiver,
                                          const ShapeNames& names) {
  const bool forwards = transfer.direction == Direction::data_from_model;
  const Direction back = forwards ? Direction::model_from_data : Direction::data_from_model;
  const AttributedMesh giver = read_giver(transfer);
  refuse_misplaced(giver.mesh, transfer.from.string(), carried_from(match, transfer.direction, names.giver));
  refuse_misplaced(receiver.mesh, receiver.name, carried_from(match, back, names.receiver));
  DenseMaps maps = dense_maps(match, forwards ? giver.mesh : receiver.mesh, forwards ? receiver.mesh : giver.mesh);
  DenseMap& map = forwards ? maps.model_from_data : maps.data_from_model;
  if (transfer.fill) fill_places(map.places, receiver.mesh, giver.mesh, match, back);
  AttributedMesh carried = carry_attributes(giver, receiver.mesh, map.places, chirality_of(match));
  std::vector<std::filesystem::path> read = transfer.read;
  read.insert(read.end(), giver.files.begin(), giver.files.end());
  const std::string name = std::filesystem::path(receiver.name).stem().string();
  write_files(attribute_files(carried, map.places, transfer.out, transfer.from.filename().string(), name), read);
  return {std::move(carried), map.placed, attribute_losses(giver, transfer.out, transfer.from.string())};
}

}  // namespace homolog
