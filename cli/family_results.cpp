// SPDX-License-Identifier: MIT
#include "family_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "exit_codes.h"
#include "homolog/base/parallel.h"
#include "homolog/outputs/doubt.h"
#include "homolog/outputs/landmarks.h"
#include "homolog/outputs/match_json.h"
#include "homolog/outputs/parts.h"
#include "homolog/outputs/report.h"
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

std::string why_nothing(const StageCounts& counts) {
  const auto& stages = counts.stages;
  auto died = stages.end();  // from the end: some sets grow without points, so a stage may be empty before one that is not
  while (died != stages.begin() && std::prev(died)->second == 0) --died;
  if (died - stages.begin() > 2) {
    return fmt::format("nothing found: the last {} {} died at the stage '{}'", std::prev(died)->second, std::prev(died)->first,
                       died->first);
  }
  const auto empty = std::find_if(stages.begin(), stages.end(), [](const auto& stage) { return stage.second == 0; });
  return fmt::format("nothing found: the stage '{}' gave none", empty->first);
}

namespace {

MatchParts nothing_covered(const DescribedFile& model, const DescribedFile& data) {
  return {{std::vector<float>(model.mesh.vertices.size(), 0), {}}, {std::vector<float>(data.mesh.vertices.size(), 0), {}}};
}

/// What is told of a family, each computed once.
struct Results {
  std::string json;
  std::vector<MatchParts> parts;                    ///< empty if nobody asks
  std::optional<std::vector<Symmetry>> symmetries;  ///< of a shape against itself
};

Results results_of(const DescribedFile& model, const DescribedFile& data, const Family& family, const Params& params, bool parts_too,
                   Against against) {
  const ThreadLimit limit(params.threads);
  Results results{match_json(model.shape, data.shape, family, params), {}, {}};
  if (parts_too) results.parts = covered_parts(model.meshed(), data.meshed(), family.matches);
  if (parts_too && against == Against::itself) results.symmetries = symmetries_of(model.meshed(), family.matches, results.parts);
  return results;
}

void write_results(const ResultFolder& folder, const DescribedFile& model, const DescribedFile& data, const Family& family,
                   const Params& params, const Results& results) {
  const Match best = family.matches.empty() ? Match{} : family.matches.front();
  const auto on_model = model_landmarks(best), on_data = data_landmarks(best);
  const std::vector<MatchParts>& parts = results.parts;
  const std::vector<Symmetry> symmetries = results.symmetries.value_or(std::vector<Symmetry>{});
  const ThreadLimit limit(params.threads);
  const MatchParts part = parts.empty() ? nothing_covered(model, data) : parts.front();
  std::vector<std::pair<std::string, Writing>> files = {
      {"match.json", whole(results.json)},
      {"parts.json", [&](const Sink& sink) { write_parts_json(model.meshed(), data.meshed(), parts, sink); }},
      {"model.part.ply", [&](const Sink& sink) { write_part_ply(model.mesh, part.model.vertices, sink); }},
      {"data.part.ply", [&](const Sink& sink) { write_part_ply(data.mesh, part.data.vertices, sink); }},
      {"model.landmarks.csv", whole(landmarks_csv(on_model))},
      {"data.landmarks.csv", whole(landmarks_csv(on_data))},
      {"model.mrk.json", whole(landmarks_markups(on_model, model.shape.ras))},
      {"data.mrk.json", whole(landmarks_markups(on_data, data.shape.ras))},
      {"report.html", whole(match_report(model.meshed(), data.meshed(), family, parts, params, symmetries))}};
  if (results.symmetries) files.emplace_back("symmetry.json", whole(symmetries_json(symmetries)));
  folder.write(files);
}

/// What is printed: the JSON, or the table with what there is to know besides.
std::string printed(const Family& family, const Results& results, const CommonOptions& options, const ResultFolder& folder) {
  if (options.json) return results.json;
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
  if (folder.wanted()) write_results(folder, model, data, family, params, results);
  console.watch().lap("writing results", family.matches.size(), "matches");
  console.clear();
  print_result(printed(family, results, options, folder));
  if (!family.matches.empty()) return kFound;
  print_message(why_nothing(family.counts));
  return kNothingFound;
}

}  // namespace homolog::cli
