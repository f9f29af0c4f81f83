// SPDX-License-Identifier: MIT
// What is painted on one shape, carried to a mesh of the other and written: the whole way from file to file, of program and Python alike.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "homolog/match/transfer.h"
#include "homolog/shape/attributes.h"
#include "homolog/shape/read_limits.h"

namespace homolog {

struct AttributeTransfer {
  std::filesystem::path from, out;
  Direction direction = Direction::data_from_model;  ///< from the giver to the receiver
  std::vector<std::string> labels = {};              ///< fields that are labels, whatever their type
  bool fill = false;                                 ///< what has no place gets what is nearest (fill_places.h)
  ReadLimits limits = {};
  std::vector<std::filesystem::path> read = {};  ///< other files that must not be overwritten
};

/// The mesh that receives, and what messages call it.
struct Receiver {
  const Mesh& mesh;
  std::string name;
};

/// What messages call the shapes that were matched.
struct ShapeNames {
  std::string giver, receiver;
};

struct TransferredAttributes {
  AttributedMesh mesh;
  std::size_t placed = 0;           ///< vertices with a place on the giver
  std::vector<std::string> losses;  ///< attribute_losses()
};

/// Throws OutputError, also for a file that was read, and FileError, also for a label that the file does not hold and for meshes that lie
/// elsewhere than the shapes lay (misplaced.h).
TransferredAttributes transfer_attributes(const AttributeTransfer& transfer, const MatchMap& match, const Receiver& receiver,
                                          const ShapeNames& names);

}  // namespace homolog
