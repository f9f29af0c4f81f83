// SPDX-License-Identifier: MIT
// Temporary names, then renaming: a reader never sees half a file.
#include "homolog/outputs/write_file.h"

#include <list>
#include <set>

#include "homolog/outputs/partial_file.h"

namespace homolog {

void write_files(const std::vector<StreamedFile>& files) {
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

void write_files(const std::vector<OutputFile>& files) {
  std::vector<StreamedFile> streamed;
  for (const OutputFile& file : files) streamed.push_back({file.path, [&](const Sink& sink) { sink(file.contents); }});
  write_files(streamed);
}

void write_file(const std::filesystem::path& path, std::string_view contents) {
  write_files(std::vector<StreamedFile>{{path, [&](const Sink& sink) { sink(contents); }}});
}

}  // namespace homolog
