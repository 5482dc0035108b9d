// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a new folder that goes away with its owner.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

namespace proptests {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    static int made = 0;
    const std::string name = "refitlab-" + std::to_string(getpid()) + "-" + std::to_string(made++);
    path_ = std::filesystem::temp_directory_path() / name;
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string path() const { return path_; }
  std::string file(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace proptests
