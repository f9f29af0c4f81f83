// SPDX-License-Identifier: MIT
// What to say of a family that holds no match worth believing; table, report and Python take it from here.
#pragma once

#include <string>

#include "homolog/match/match.h"

namespace homolog {

/// A sentence when every match is more probably wrong than right, else nothing; nothing of an empty family.
std::string doubt_sentence(const Family& family);

/// The same of one match, by its confidence.
std::string doubt_of_match(double confidence);

}  // namespace homolog
