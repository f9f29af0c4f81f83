// SPDX-License-Identifier: MIT
#include "homolog/outputs/report.h"

#include "homolog/outputs/match_json.h"
#include "homolog/outputs/report_mesh.h"
#include "homolog/outputs/report_template.h"

namespace homolog {
namespace {

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

std::string page(const std::string& result, const nlohmann::ordered_json& meshes) {
  std::string text;
  for (const std::string_view piece : report_template) text += piece;
  static constexpr std::string_view kPlace = "{{report}}";
  text.replace(text.rfind(kPlace), kPlace.size(), without_markup("{\"result\": " + result + ", \"meshes\": " + meshes.dump() + "}"));
  return text;
}

}  // namespace

std::string match_report(const ReportShape& model, const ReportShape& data, const Family& family, const Params& params) {
  return page(match_json(model.shape, data.shape, family, params), {mesh_for_page(model.mesh), mesh_for_page(data.mesh)});
}

std::string points_report(const ReportShape& shape, const Params& params) {
  return page(points_json(shape.shape, params), nlohmann::ordered_json::array({mesh_for_page(shape.mesh)}));
}

}  // namespace homolog
