// SPDX-License-Identifier: MIT
#include "homolog/base/large_memory.h"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace homolog {

void prefer_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const auto first = (begin + huge_page - 1) / huge_page * huge_page, last = (begin + bytes) / huge_page * huge_page;
  if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
}

std::vector<float> large_zeros(std::size_t count) {
  std::vector<float> zeros;
  zeros.reserve(count);
  prefer_huge_pages(zeros.data(), count * sizeof(float));
  zeros.resize(count);
  return zeros;
}

}  // namespace homolog
