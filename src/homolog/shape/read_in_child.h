// SPDX-License-Identifier: MIT
// A fence around readers that are not ours: they run in a child process with limits on memory and time, so that whatever a damaged file
// does to them ends as one sentence.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "homolog/shape/mesh.h"

namespace homolog {

struct ChildLimits {
  std::uint64_t bytes = std::uint64_t{4} << 30;  ///< of memory beyond what this process has already
  unsigned seconds = 5;                          ///< of processor time; a child that waits instead is ended after ten times as long
};

/// What `read` returns in a child process of this one. Throws FileError with the message of the FileError that `read` threw, or, naming
/// `file`, when the child crashed or reached a limit. Files change for all; memory does not: what `read` does stays in the child.
Mesh read_in_child(const std::function<Mesh()>& read, const std::string& file, const ChildLimits& limits);

}  // namespace homolog
