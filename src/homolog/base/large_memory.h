// SPDX-License-Identifier: MIT
// Memory in huge pages, where the system lends them: asking it for every small page takes longer than much of what is done with volumes.
#pragma once

#include <cstddef>
#include <vector>

namespace homolog {

inline constexpr std::size_t huge_page = 2 << 20;

/// Asks for huge pages for memory that has not been touched yet.
void prefer_huge_pages(void* memory, std::size_t bytes);

std::vector<float> large_zeros(std::size_t count);

}  // namespace homolog
