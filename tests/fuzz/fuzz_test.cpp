// SPDX-License-Identifier: MIT
// Every fuzz target for a moment, without libFuzzer: its own files, all their beginnings, and thousands of random changes of them, always
// the same ones. A broken promise ends the process; under the sanitizers of the preset `dev` memory is watched, too.
#include <gtest/gtest.h>

#include <random>

#include "fuzz/target.h"

namespace homolog::fuzz {
namespace {

struct EachTarget : testing::TestWithParam<Target> {};

/// Random numbers that are the same everywhere: the standard fixes mt19937, but not its distributions.
class Dice {
 public:
  std::size_t below(std::size_t end) { return end == 0 ? 0 : generator_() % end; }

 private:
  std::mt19937 generator_{2005};
};

std::string changed(std::string bytes, const std::vector<std::string>& seeds, Dice& dice) {
  static const std::vector<std::string> lies{
      "-1", "0",  "4294967295", "99999999999999999999", "1e300",           "-1e-300", "nan", "inf", "\n",
      " ",  "\"", ",",          std::string(1, '\0'),   "\xff\xff\xff\xff"};
  for (std::size_t changes = 1 + dice.below(4); changes > 0; --changes) {
    const std::size_t place = dice.below(bytes.size() + 1), length = dice.below(std::min<std::size_t>(16, bytes.size() - place) + 1);
    switch (dice.below(6)) {
      case 0:
        bytes.erase(place, length);
        break;
      case 1:
        bytes.insert(place, bytes.substr(place, length));
        break;
      case 2:
        bytes.replace(place, length, lies[dice.below(lies.size())]);
        break;
      case 3:
        bytes.resize(place);
        break;
      case 4: {
        const std::string& other = seeds[dice.below(seeds.size())];
        bytes.replace(place, std::string::npos, other.substr(dice.below(other.size() + 1)));
        break;
      }
      default:
        if (place < bytes.size()) bytes[place] = static_cast<char>(bytes[place] ^ (1 << dice.below(8)));
    }
  }
  return bytes;
}

TEST_P(EachTarget, KeepsItsPromisesForItsOwnFilesAndTheirBeginnings) {
  for (const std::string& seed : GetParam().seeds) {
    for (std::size_t length = 0; length <= seed.size(); ++length) GetParam().run(seed.substr(0, length));
  }
}

TEST_P(EachTarget, KeepsItsPromisesForChangedFiles) {
  Dice dice;
  const std::vector<std::string>& seeds = GetParam().seeds;
  for (int i = 0; i < GetParam().changed_files; ++i) GetParam().run(changed(seeds[dice.below(seeds.size())], seeds, dice));
}

INSTANTIATE_TEST_SUITE_P(Fuzz, EachTarget, testing::ValuesIn(all_targets()), [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace homolog::fuzz
