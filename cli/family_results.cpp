// SPDX-License-Identifier: MIT
#include "family_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "exit_codes.h"
#include "homolog/base/parallel.h"
#include "homolog/outputs/doubt.h"
#include "homolog/outputs/family_files.h"
#include "homolog/outputs/match_json.h"
#include "homolog/outputs/symmetry_text.h"

namespace homolog::cli {

std::string family_table(const Family& family) {
  if (family.matches.empty()) return "";
  std::string table = "rank  pairs  confidence  handedness     scale   bending   chamfer  of model  of data\n";
  int rank = 0;
  for (const Match& match : family.matches) {
    table += fmt::format("{:4}  {:5}  {:10.2f}  {:10}  {:#8.4g}  {:8.4f}  {:8.4f}  {:6.0f} %  {:5.0f} %\n", ++rank, match.pairs.size(),
                         match.confidence, handedness_name(match.handedness), match.similarity.scale, match.bending, match.chamfer,
                         100 * match.model_coverage, 100 * match.data_coverage);
  }
  return table;
}

std::string why_nothing(const Shape& model, const Shape& data, const StageCounts& counts) {
  if (model.points.empty()) return no_points(model);
  if (data.points.empty()) return no_points(data);
  // From the end: some sets grow without points, so a stage may be empty before one that is not.
  auto last = std::prev(counts.stages.end());
  while (last != counts.stages.begin() && last->second == 0) --last;
  return fmt::format("nothing found: none of {} {} between {} and {} is a match; a higher --resolution shows more of them", last->second,
                     last->first, model.name, data.name);
}

namespace {

/// What is told of a family, each computed once.
struct Results {
  std::vector<MatchParts> parts;                    ///< empty if nobody asks
  std::optional<std::vector<Symmetry>> symmetries;  ///< of a shape against itself
};

Results results_of(const DescribedFile& model, const DescribedFile& data, const Family& family, const Params& params, bool parts_too,
                   Against against) {
  const ThreadLimit limit(params.threads);
  Results results;
  if (parts_too) results.parts = covered_parts(model.meshed(), data.meshed(), family.matches);
  if (parts_too && against == Against::itself) results.symmetries = symmetries_of(model.meshed(), family.matches, results.parts);
  return results;
}

void write_results(const ResultFolder& folder, const ToldFamily& told) {
  const ThreadLimit limit(told.params.threads);
  folder.write(family_files(told));
}

/// The table with what there is to know besides.
std::string table_and_more(const Family& family, const Results& results, const ResultFolder& folder) {
  std::string text = family_table(family);
  if (const std::string doubt = doubt_sentence(family); !doubt.empty()) text += doubt + "\n";
  if (results.symmetries) text += symmetries_text(*results.symmetries);
  if (folder.wanted()) text += fmt::format("The report is {}\n", (folder / "report.html").string());
  return text;
}

}  // namespace

int deliver(const DescribedFile& model, const DescribedFile& data, const Family& family, const Params& params, const CommonOptions& options,
            const ResultFolder& folder, Console& console, Against against) {
  console.stage("writing results");
  const bool parts_too = folder.wanted() || (against == Against::itself && !options.json);
  const Results results = results_of(model, data, family, params, parts_too, against);
  if (folder.wanted()) write_results(folder, {model.meshed(), data.meshed(), family, params, results.parts, results.symmetries});
  console.watch().lap("writing results", family.matches.size(), "matches");
  console.clear();
  print_result(options.json ? match_json(model.shape, data.shape, family, params) : table_and_more(family, results, folder));
  if (!family.matches.empty()) return kFound;
  print_message(why_nothing(model.shape, data.shape, family.counts));
  return kNothingFound;
}

}  // namespace homolog::cli
