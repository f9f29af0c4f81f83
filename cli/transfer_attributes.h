// SPDX-License-Identifier: MIT
// homolog transfer --attributes: what is painted on one shape, carried to the other.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "console.h"
#include "homolog/outputs/attribute_transfer.h"
#include "stored_match.h"

namespace homolog::cli {

struct AttributeOptions {
  std::string from;                 ///< the file with the attributes; empty: none are carried
  std::string onto;                 ///< the mesh that receives them; empty: the one that was matched
  std::vector<std::string> labels;  ///< fields that are labels, whatever their type
  bool fill = false;                ///< what has no place gets what is nearest
};

/// --attributes, --onto, --labels and --fill.
void add_attribute_options(CLI::App& verb, AttributeOptions& options);

/// Throws UsageError for options without --attributes, and for an `out` that cannot be written.
void check_options(const AttributeOptions& options, const std::string& out);

/// Carries, writes, tells; returns the exit code. `onto`: the file of the receiver; empty: the mesh beside the match.
int transfer_attributes(const AttributeTransfer& transfer, const std::string& onto, const StoredMatchOptions& options,
                        const StoredFamily& family, const MatchMap& match, Console& console);

}  // namespace homolog::cli
