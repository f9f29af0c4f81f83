// SPDX-License-Identifier: MIT
// Landmark files as labels and arrays; NaN is missing.
#pragma once

#include <nanobind/nanobind.h>

namespace homolog::python {

/// The functions read_landmarks, write_landmarks and write_carried.
void bind_landmarks(nanobind::module_& module);

}  // namespace homolog::python
