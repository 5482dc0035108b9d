// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/resume/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace refitlab {

FolderLock::FolderLock(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const std::string path = (std::filesystem::path(folder) / "lock").string();
  // The file stays when the lock goes: one that was removed might be locked by one run while the next makes another.
  file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) throw std::runtime_error(path + ": cannot lock: " + std::strerror(errno));
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    const int reason = errno;
    char holder[16] = {};
    const ssize_t length = ::read(file_, holder, sizeof holder - 1);
    ::close(file_);
    if (reason != EWOULDBLOCK) throw std::runtime_error(path + ": cannot lock: " + std::strerror(reason));
    throw std::runtime_error(folder + ": in use by another run" +
                             (length > 0 ? ", process " + std::string(holder) : std::string()));
  }
  const std::string holder = std::to_string(::getpid());
  if (::ftruncate(file_, 0) != 0 || ::write(file_, holder.data(), holder.size()) < 0) {
    const int reason = errno;
    ::close(file_);
    throw std::runtime_error(path + ": cannot write: " + std::strerror(reason));
  }
}

FolderLock::~FolderLock() { ::close(file_); }

}  // namespace refitlab
