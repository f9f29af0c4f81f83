// SPDX-License-Identifier: MIT
// `report.html`: one self-contained page that works offline (viewer/ bundled with three.js). Input is data, never markup.
#pragma once

#include <string>

#include "homolog/homolog.h"

namespace homolog {

/// What the report draws of one side.
struct ReportShape {
  const Mesh& mesh;
  const Shape& shape;
};

std::string match_report(const ReportShape& model, const ReportShape& data, const Family& family, const Params& params);
std::string points_report(const ReportShape& shape, const Params& params);

}  // namespace homolog
