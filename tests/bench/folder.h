// SPDX-License-Identifier: MIT
// A folder of the bench, written for one test and removed after it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace homolog::bench {

struct Folder {
  std::filesystem::path path = std::filesystem::path(testing::TempDir()) /
                               (std::string("homolog_") + testing::UnitTest::GetInstance()->current_test_info()->test_suite_name() + "_" +
                                testing::UnitTest::GetInstance()->current_test_info()->name());
  Folder() { std::filesystem::remove_all(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path / name).parent_path());
    std::ofstream(path / name, std::ios::binary) << text;
  }
};

}  // namespace homolog::bench
