// SPDX-License-Identifier: MIT
// Functions on vectors of 16 floats or 8 doubles, which the compiler splits into what the processor at hand has: a whole, a half or a
// quarter of them at once, chosen at run time.
// There must be no fused multiply-add in them, whose rounding differs: CMakeLists.txt forbids it to the compiler, file by file. Under
// ThreadSanitizer there is no choice: it is made before that sanitizer has started, and crashes.
#pragma once

#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define HOMOLOG_WIDEST_CLONE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define HOMOLOG_WIDEST_CLONE
#endif

namespace homolog {

/// In memory; need not be aligned.
using SixteenFloats [[gnu::vector_size(64), gnu::aligned(4), gnu::may_alias]] = float;

/// In memory; need not be aligned.
using EightDoubles [[gnu::vector_size(64), gnu::aligned(8), gnu::may_alias]] = double;

[[gnu::always_inline]] inline const SixteenFloats& sixteen(const float* p) { return *reinterpret_cast<const SixteenFloats*>(p); }
[[gnu::always_inline]] inline SixteenFloats& sixteen(float* p) { return *reinterpret_cast<SixteenFloats*>(p); }

}  // namespace homolog
