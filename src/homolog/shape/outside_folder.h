// SPDX-License-Identifier: MIT
#pragma once

#include "homolog/base/errors.h"

namespace homolog {

/// A file names another one that does not lie in its folder, and that is not opened.
struct OutsideFolder : FileError {
  using FileError::FileError;
};

}  // namespace homolog
