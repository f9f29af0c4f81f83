// SPDX-License-Identifier: MIT
// A folder of results: no file gets its name before all are written.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "homolog/outputs/sink.h"

namespace homolog {

/// Files by their names in a folder.
using NamedFiles = std::vector<std::pair<std::string, Writing>>;

/// Throws OutputError unless the folder can be written into, or be made where it would lie. Nothing is tried out: what one process made for
/// a trial and took away again could be what another one is about to use.
void require_writable_folder(const std::filesystem::path& path);

/// Makes the folder and those above it, and writes all files or none. Throws OutputError, also for one of `read` as write_files() does, and
/// takes away again what it made.
void write_folder(const std::filesystem::path& folder, const NamedFiles& files, const std::vector<std::filesystem::path>& read = {});

}  // namespace homolog
