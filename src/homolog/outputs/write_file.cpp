// SPDX-License-Identifier: MIT
// Temporary names, then renaming: a reader never sees half a file.
#include "homolog/outputs/write_file.h"

#include <fmt/format.h>

#include <list>
#include <set>
#include <system_error>

#include "homolog/base/errors.h"
#include "homolog/outputs/partial_file.h"

namespace homolog {
namespace {

void refuse_to_overwrite(const std::filesystem::path& file, const std::vector<std::filesystem::path>& read) {
  for (const std::filesystem::path& other : read) {
    std::error_code neither_is_there;
    if (!std::filesystem::equivalent(file, other, neither_is_there)) continue;
    throw OutputError(fmt::format("cannot write '{}': it was read to make this, and would be lost; choose another name", file.string()));
  }
}

}  // namespace

void write_files(const std::vector<StreamedFile>& files, const std::vector<std::filesystem::path>& read) {
  for (const StreamedFile& file : files) refuse_to_overwrite(file.path, read);
  std::set<std::filesystem::path> folders;
  for (const StreamedFile& file : files) folders.insert(file.path.parent_path());
  for (const std::filesystem::path& folder : folders) remove_leftovers(folder);
  std::list<PartialFile> partial;
  for (const StreamedFile& file : files) {
    PartialFile& made = partial.emplace_back(file.path);
    file.writing([&](std::string_view piece) { made.append(piece); });
    made.complete();
  }
  for (PartialFile& file : partial) file.rename();
}

void write_files(const std::vector<OutputFile>& files, const std::vector<std::filesystem::path>& read) {
  std::vector<StreamedFile> streamed;
  for (const OutputFile& file : files) streamed.push_back({file.path, [&](const Sink& sink) { sink(file.contents); }});
  write_files(streamed, read);
}

void write_file(const std::filesystem::path& path, std::string_view contents) {
  write_files(std::vector<StreamedFile>{{path, [&](const Sink& sink) { sink(contents); }}});
}

}  // namespace homolog
