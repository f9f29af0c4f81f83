// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

namespace homolog {

/// Takes a sentence about what a file holds and is left out, or is read otherwise than it may be meant.
using Tell = std::function<void(const std::string& sentence)>;

}  // namespace homolog
