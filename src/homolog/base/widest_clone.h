// SPDX-License-Identifier: MIT
// Functions on vectors of 8 floats or 4 doubles, which the compiler makes of what the processor at hand has: whole ones or halves, chosen
// at run time.
// There must be no fused multiply-add in them, whose rounding differs: CMakeLists.txt forbids it to the compiler, file by file. Under
// ThreadSanitizer there is no choice: it is made before that sanitizer has started, and crashes.
#pragma once

#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define HOMOLOG_WIDEST_CLONE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define HOMOLOG_WIDEST_CLONE
#endif

namespace homolog {

/// In memory; need not be aligned. No wider ones: choices on vectors that the processor does not have are compiled lane by lane, which
/// takes up to nine times as long.
using EightFloats [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = float;
using FourDoubles [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;

[[gnu::always_inline]] inline const EightFloats& eight(const float* p) { return *reinterpret_cast<const EightFloats*>(p); }
[[gnu::always_inline]] inline EightFloats& eight(float* p) { return *reinterpret_cast<EightFloats*>(p); }

}  // namespace homolog
