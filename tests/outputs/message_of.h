// SPDX-License-Identifier: MIT
// What a reader says of a file that it refuses.
#pragma once

#include <string>

#include "homolog/base/errors.h"

namespace homolog {

/// The message of the FileError that `read` throws; empty if it throws none.
template <class Read>
std::string message_of(const Read& read) {
  try {
    read();
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

}  // namespace homolog
