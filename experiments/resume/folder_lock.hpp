// SPDX-License-Identifier: GPL-3.0-or-later
// A folder is used by one run at a time.
#pragma once

#include <string>

namespace refitlab {

// Holds the folder (made if missing) by its file "lock" until it goes out of scope or the process ends, however it
// ends. Throws std::runtime_error that names the folder and the process that holds it.
class FolderLock {
 public:
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_;
};

}  // namespace refitlab
