// SPDX-License-Identifier: MIT
#include "homolog/match/solve_rows.h"

#include "homolog/base/widest_clone.h"

namespace homolog {
namespace {

// What lies below the unit diagonal of L, column after column.
struct Columns {
  const int *first, *row;
  const double* value;
};

HOMOLOG_WIDEST_CLONE void substitute(int count, const Columns& lower, const double* diagonal, FourDoubles* x) {
  for (int c = 0; c < count; ++c) {
    const FourDoubles here = x[c];
    for (int p = lower.first[c]; p < lower.first[c + 1]; ++p) x[lower.row[p]] -= lower.value[p] * here;
  }
  for (int c = 0; c < count; ++c) x[c] *= 1 / diagonal[c];
  for (int c = count - 1; c >= 0; --c) {
    FourDoubles here = x[c];
    for (int p = lower.first[c]; p < lower.first[c + 1]; ++p) here -= lower.value[p] * x[lower.row[p]];
    x[c] = here;
  }
}

}  // namespace

void solve_rows(const OrderedFactor& factor, PlaceRows& rows) {
  const auto& lower = factor.matrixL().nestedExpression();
  const auto diagonal = factor.vectorD();
  substitute(static_cast<int>(rows.rows()), {lower.outerIndexPtr(), lower.innerIndexPtr(), lower.valuePtr()}, diagonal.data(),
             reinterpret_cast<FourDoubles*>(rows.data()));
}

}  // namespace homolog
