// SPDX-License-Identifier: MIT
// Memory in huge pages, where the system lends them: asking it for every small page takes longer than much of what is done with volumes.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace homolog {

inline constexpr std::size_t huge_page = 2 << 20;

/// Asks for huge pages for memory that has not been touched yet.
void prefer_huge_pages(void* memory, std::size_t bytes);

/// Gives the memory of what will not be used any more back to the system, though it is owned by somebody; what it holds is lost, or not.
void forget(std::string_view bytes);

std::vector<float> large_zeros(std::size_t count);

}  // namespace homolog
