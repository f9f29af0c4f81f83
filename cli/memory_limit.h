// SPDX-License-Identifier: MIT
// How much memory a run may take: where it asks for more, that becomes a message, before the system ends it without a word.
#pragma once

#include <cstdint>

namespace homolog::cli {

/// From here on no more than the machine has free now, or its container may have at all; no limit where the system does not tell.
void limit_memory_to_free();

/// From here on no more than this; 0 for no limit.
void limit_memory(std::uint64_t mebibytes);

}  // namespace homolog::cli
