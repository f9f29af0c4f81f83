// SPDX-License-Identifier: MIT
// One target under libFuzzer (scripts/fuzz.sh):
//   homolog_fuzz --target=off CORPUS [libFuzzer's options]   fuzzes it, after the target's own files are put into CORPUS; files may
//                                                            become half as long again as the longest of these
//   homolog_fuzz --targets                                   lists the targets
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "fuzz/target.h"
#include "homolog/base/parallel.h"

namespace {

homolog::fuzz::Target chosen;

/// A file is too small to be shared, and libFuzzer follows one thread.
const homolog::ThreadLimit one_thread(1);

void write_seeds(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (std::size_t i = 0; i < chosen.seeds.size(); ++i) {
    std::ofstream(folder / ("seed" + std::to_string(i)), std::ios::binary) << chosen.seeds[i];
  }
}

/// libFuzzer's own default would cut off the longest of the target's files, which then are refused.
void set_length(int& argc, char**& argv) {
  std::size_t longest = 0;
  for (const std::string& seed : chosen.seeds) longest = std::max(longest, seed.size());
  static std::string option = "-max_len=" + std::to_string(longest + longest / 2 + 16);
  static std::vector<char*> words(argv, argv + argc);
  words.push_back(option.data());
  words.push_back(nullptr);
  argc = static_cast<int>(words.size()) - 1;
  argv = words.data();
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  const std::string word = *argc > 1 ? (*argv)[1] : "";
  for (homolog::fuzz::Target& target : homolog::fuzz::all_targets()) {
    if (word == "--targets") std::puts(target.name);
    if (word == std::string("--target=") + target.name) chosen = std::move(target);
  }
  if (word == "--targets") std::exit(0);
  if (!chosen.run || *argc < 3) {
    std::fprintf(stderr, "homolog_fuzz: say --target=NAME CORPUS; --targets lists the names\n");
    std::exit(2);
  }
  write_seeds((*argv)[2]);
  set_length(*argc, *argv);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen.run(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
