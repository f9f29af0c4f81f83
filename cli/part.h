// SPDX-License-Identifier: MIT
// A part of a shape named by shares of its bounding box: "y>0.5", "x<0.3,z>0.2", "y=0.4..0.8".
#pragma once

#include <string>

#include "homolog/shape/mesh.h"

namespace homolog::cli {

/// The box in shares (0 to 1 per axis). Throws UsageError for what is not understood or leaves nothing.
Box parse_part(const std::string& text);

}  // namespace homolog::cli
