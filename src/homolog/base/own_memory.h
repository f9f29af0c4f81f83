// SPDX-License-Identifier: MIT
// What a limit of memory (RLIMIT_DATA) is counted in.
#pragma once

#include <cstdint>

namespace homolog {

/// Memory that this process can write to, shared with nobody; 0 where the system does not tell.
std::uint64_t data_bytes();

}  // namespace homolog
