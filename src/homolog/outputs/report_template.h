// SPDX-License-Identifier: MIT
// The page of report.html with {{report}} where its data goes, in pieces; made from viewer/ when the library is built.
#pragma once

#include <string_view>
#include <vector>

namespace homolog {

extern const std::vector<std::string_view> report_template;

}  // namespace homolog
