// SPDX-License-Identifier: MIT
// The two inner loops of the scale space, on whole rows of floats. Every sum is made in one fixed order by single additions and
// multiplications, so that all widths of the processor's registers give the same bytes.
#pragma once

namespace homolog {

/// Rows are worked on in blocks of so many floats; `begin` and `end` below are multiples of it.
inline constexpr int row_block = 16;

/// out[x] = weights[0] rows[0][x] + sum over t = 1..radius of weights[t] (rows[-t][x] + rows[t][x]), for begin <= x < end.
void weigh_rows(const float* const* rows, const float* weights, int radius, int begin, int end, float* out);

/// row[x] = factor (row[x] - other[x]), for begin <= x < end.
void subtract_row(const float* other, float factor, int begin, int end, float* row);

}  // namespace homolog
