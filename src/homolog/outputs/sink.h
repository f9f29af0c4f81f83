// SPDX-License-Identifier: MIT
// Files made piece by piece, so that those of large meshes need not be in memory as a whole.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace homolog {

/// Takes the bytes of a file, piece by piece in their order.
using Sink = std::function<void(std::string_view)>;

/// Makes the bytes of a file.
using Writing = std::function<void(const Sink&)>;

/// What makes this text.
Writing whole(std::string text);

/// What is made, in one text.
std::string text_of(const Writing& writing);

}  // namespace homolog
