// SPDX-License-Identifier: MIT
// Files for the tests of the readers: written into a folder of their own that goes away with the test.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "homolog/base/errors.h"
#include "homolog/shape/read_mesh.h"

namespace homolog {

class FileTest : public testing::Test {
 protected:
  FileTest() { std::filesystem::create_directories(folder_); }
  ~FileTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }
  Mesh read(const std::string& name, const std::string& content) const { return read_mesh(write(name, content)); }

  /// What is said while it is read, in lines.
  std::string told(const std::string& name, const std::string& content) const {
    std::string lines;
    read_mesh(write(name, content), {}, {}, [&](const std::string& sentence) { lines += sentence + "\n"; });
    return lines;
  }

  /// Expects a FileError that names the file and says `what`.
  void expect_error(const std::string& name, const std::string& content, const std::string& what) const {
    try {
      read(name, content);
      ADD_FAILURE() << "no FileError for " << content.substr(0, 200);
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("homolog_") + testing::UnitTest::GetInstance()->current_test_info()->test_suite_name() + "_" +
       testing::UnitTest::GetInstance()->current_test_info()->name());
};

}  // namespace homolog
