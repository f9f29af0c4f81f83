// SPDX-License-Identifier: MIT
#include "homolog/outputs/report.h"

#include "homolog/outputs/doubt.h"
#include "homolog/outputs/match_json.h"
#include "homolog/outputs/report_mesh.h"
#include "homolog/outputs/report_template.h"
#include "homolog/outputs/symmetry_text.h"

namespace homolog {
namespace {

using nlohmann::ordered_json;

/// JSON may spell `<` as an escape: then no file name can end the page's data or become markup.
std::string without_markup(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

std::string page(const std::string& result, const std::string& doubt, const ordered_json& meshes, const ordered_json& parts,
                 const std::vector<Symmetry>& symmetries) {
  std::string text;
  for (const std::string_view piece : report_template) text += piece;
  static constexpr std::string_view kPlace = "{{report}}";
  text.replace(text.rfind(kPlace), kPlace.size(),
               without_markup("{\"result\": " + result + ", \"doubt\": " + ordered_json(doubt).dump() + ", \"meshes\": " + meshes.dump() +
                              ", \"parts\": " + parts.dump() + ", \"itself\": " + symmetries_json(symmetries) + "}"));
  return text;
}

}  // namespace

std::string match_report(const MeshedShape& model, const MeshedShape& data, const Family& family, const std::vector<MatchParts>& parts,
                         const Params& params, const std::vector<Symmetry>& symmetries) {
  const ClusteredMesh drawn_model = mesh_to_draw(model.mesh), drawn_data = mesh_to_draw(data.mesh);
  ordered_json weights = ordered_json::array();
  for (const MatchParts& part : parts) {
    weights.push_back({weights_for_page(drawn_model, part.model.vertices), weights_for_page(drawn_data, part.data.vertices)});
  }
  return page(match_json(model.shape, data.shape, family, params), doubt_sentence(family),
              {mesh_for_page(model.mesh, drawn_model), mesh_for_page(data.mesh, drawn_data)}, weights, symmetries);
}

std::string points_report(const MeshedShape& shape, const Params& params) {
  return page(points_json(shape.shape, params), "", ordered_json::array({mesh_for_page(shape.mesh, mesh_to_draw(shape.mesh))}),
              ordered_json::array(), {});
}

}  // namespace homolog
