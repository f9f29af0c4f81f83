// SPDX-License-Identifier: MIT
// The manual page, from the same tables as --help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace homolog::cli {

/// homolog(1) in the macros of man(7). Options of a group other than "Options" are the same for all verbs that have them, so each group
/// gets a section of its own.
std::string manual_page(const CLI::App& program);

}  // namespace homolog::cli
