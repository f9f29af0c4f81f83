// SPDX-License-Identifier: MIT
// One target under libFuzzer (scripts/fuzz.sh):
//   homolog_fuzz --target=off CORPUS [libFuzzer's options]   fuzzes it, after the target's own files are put into CORPUS
//   homolog_fuzz --targets                                   lists the targets
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "fuzz/target.h"

namespace {

homolog::fuzz::Target chosen;

void write_seeds(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (std::size_t i = 0; i < chosen.seeds.size(); ++i) {
    std::ofstream(folder / ("seed" + std::to_string(i)), std::ios::binary) << chosen.seeds[i];
  }
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
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen.run(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
