// SPDX-License-Identifier: MIT
// On what numbers were measured.
#pragma once

#include <string>

namespace homolog::bench {

/// "Intel Xeon, 2 cores, cache 33792 KB, at 2d3e551-dirty", as far as the system and git tell.
std::string machine_and_commit();

}  // namespace homolog::bench
