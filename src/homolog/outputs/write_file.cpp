// SPDX-License-Identifier: MIT
// Temporary names, then renaming: a reader never sees half a file.
#include "homolog/outputs/write_file.h"

#include <list>
#include <set>

#include "homolog/outputs/partial_file.h"

namespace homolog {

void write_files(const std::vector<OutputFile>& files) {
  std::set<std::filesystem::path> folders;
  for (const OutputFile& file : files) folders.insert(file.path.parent_path());
  for (const std::filesystem::path& folder : folders) remove_leftovers(folder);
  std::list<PartialFile> partial;
  for (const OutputFile& file : files) partial.emplace_back(file.path, file.contents);
  for (PartialFile& file : partial) file.rename();
}

void write_file(const std::filesystem::path& path, std::string_view contents) {
  remove_leftovers(path.parent_path());
  PartialFile(path, contents).rename();
}

}  // namespace homolog
