// SPDX-License-Identifier: MIT
// What a user takes home from a family of matches: the table, the JSON, the files.
#pragma once

#include "console.h"
#include "described_file.h"
#include "options.h"
#include "result_folder.h"

namespace homolog::cli {

/// rank, pairs, confidence, handedness, scale, bending, chamfer, covered shares; one line a match, empty for an empty family.
std::string family_table(const Family& family);

/// Why a family is empty, at which stage the last candidate died, and what to do, as a sentence.
std::string why_nothing(const Shape& model, const Shape& data, const StageCounts& counts);

/// A shape against itself has symmetries, which are told besides.
enum class Against { another, itself };

/// Writes the files, prints the table or JSON, and returns the exit code. Everything is computed before anything is written but the text
/// of the largest files.
int deliver(const DescribedFile& model, const DescribedFile& data, const Family& family, const Params& params, const CommonOptions& options,
            const ResultFolder& folder, Console& console, Against against = Against::another);

}  // namespace homolog::cli
