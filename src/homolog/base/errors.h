// SPDX-License-Identifier: MIT
// What the library throws. Bad input is an exception with one clear sentence; nothing found is not an error.
#pragma once

#include <stdexcept>
#include <string>

namespace homolog {

/// Base of all errors of the library; what() is one sentence for the user.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file cannot be read as what it claims to be. what() names the file, the place in it, and what to do.
struct FileError : Error {
  using Error::Error;
};

/// A shape was read but cannot be used (no inside, zero volume, non-finite coordinates, ...).
struct ShapeError : Error {
  using Error::Error;
};

/// A parameter is unknown, malformed or out of range. what() names it, its value and its range.
struct ParamError : Error {
  using Error::Error;
};

/// A result cannot be written.
struct OutputError : Error {
  using Error::Error;
};

}  // namespace homolog
