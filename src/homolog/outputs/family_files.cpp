// SPDX-License-Identifier: MIT
#include "homolog/outputs/family_files.h"

#include "homolog/outputs/landmarks.h"
#include "homolog/outputs/match_json.h"
#include "homolog/outputs/parts.h"
#include "homolog/outputs/report.h"
#include "homolog/outputs/symmetry_text.h"

namespace homolog {
namespace {

/// Of an empty family nothing is covered.
MatchParts best_parts(const ToldFamily& told) {
  if (!told.parts.empty()) return told.parts.front();
  return {{std::vector<float>(told.model.mesh.vertices.size(), 0), {}, {}},
          {std::vector<float>(told.data.mesh.vertices.size(), 0), {}, {}}};
}

}  // namespace

NamedFiles family_files(const ToldFamily& told) {
  const auto& [model, data, family, params, parts, symmetries] = told;
  const Match best = family.matches.empty() ? Match{} : family.matches.front();
  const auto on_model = model_landmarks(best), on_data = data_landmarks(best);
  NamedFiles files = {
      {"match.json", whole(match_json(model.shape, data.shape, family, params))},
      {"parts.json", [&told](const Sink& sink) { write_parts_json(told.model, told.data, told.parts, sink); }},
      {"model.part.ply", [&told](const Sink& sink) { write_part_ply(told.model.mesh, best_parts(told).model.vertices, sink); }},
      {"data.part.ply", [&told](const Sink& sink) { write_part_ply(told.data.mesh, best_parts(told).data.vertices, sink); }},
      {"model.landmarks.csv", whole(landmarks_csv(on_model))},
      {"data.landmarks.csv", whole(landmarks_csv(on_data))},
      {"model.mrk.json", whole(landmarks_markups(on_model, model.shape.ras))},
      {"data.mrk.json", whole(landmarks_markups(on_data, data.shape.ras))},
      {"report.html", whole(match_report(model, data, family, parts, params, symmetries.value_or(std::vector<Symmetry>{})))}};
  if (symmetries) files.emplace_back("symmetry.json", whole(symmetries_json(*symmetries)));
  return files;
}

}  // namespace homolog
