// SPDX-License-Identifier: MIT
#include "algorithms/results/write_whole.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace refitlab {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const char* what, int error) {
  throw std::runtime_error(path + ": cannot " + what + ": " + std::strerror(error));
}

// Opens a new file beside path that no other process or thread has.
int open_temporary(const std::string& path, std::string& name) {
  for (int attempt = 0;; ++attempt) {
    name = path + ".tmp" + std::to_string(::getpid()) + "-" + std::to_string(attempt);
    const int file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST) return file;
  }
}

bool write_all(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = ::write(file, text.data() + done, text.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    done += static_cast<std::size_t>(written);
  }
  return true;
}

// Returns the file that a symbolic link leads to, or else the path.
std::string followed(const std::string& path) {
  std::error_code error;
  const fs::path target = fs::canonical(path, error);
  return !error && fs::is_regular_file(target, error) ? target.string() : path;
}

// Returns whether the path is a device, a pipe or a socket. Such a file takes the text itself, and no other file may come in its
// place.
bool is_special(const std::string& path) {
  struct stat about {};
  return ::stat(path.c_str(), &about) == 0 && !S_ISREG(about.st_mode) && !S_ISDIR(about.st_mode);
}

void write_into(const std::string& path, const std::string& text) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  if (file < 0) fail(path, "write", errno);
  const bool written = write_all(file, text);
  const int reason = errno;
  const bool closed = ::close(file) == 0;
  if (!written || !closed) fail(path, "write", written ? errno : reason);
}

// Without this the new name may not survive a power failure. Some file systems cannot do it; the file is whole nevertheless.
void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

void write_whole(const std::string& name, const std::string& text) {
  if (is_special(name)) return write_into(name, text);
  const std::string path = followed(name);
  const fs::path folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
  std::error_code error;
  fs::create_directories(folder, error);
  std::string temporary;
  const int file = open_temporary(path, temporary);
  if (file < 0) fail(path, "write", errno);
  // Who may read the old file may read the new one. Where that cannot be said, it is as for any new file.
  struct stat old {};
  if (::stat(path.c_str(), &old) == 0) static_cast<void>(::fchmod(file, old.st_mode & 07777) == 0);
  const bool written = write_all(file, text) && ::fsync(file) == 0;
  const int reason = errno;
  const bool closed = ::close(file) == 0;
  if (!written || !closed) {
    ::unlink(temporary.c_str());
    fail(path, "write", written ? errno : reason);
  }
  if (::rename(temporary.c_str(), path.c_str()) != 0) {
    const int refused = errno;
    ::unlink(temporary.c_str());
    fail(path, "replace", refused);
  }
  sync_folder(folder);
}

void check_writable(const std::string& name) {
  std::error_code error;
  if (fs::is_directory(name, error)) fail(name, "replace", EISDIR);
  if (is_special(name)) {
    if (::access(name.c_str(), W_OK) != 0) fail(name, "write", errno);
    return;
  }
  // The folders that are missing would be made in the last one that is there.
  fs::path folder = fs::absolute(followed(name), error).parent_path();
  while (folder.has_relative_path() && ::access(folder.c_str(), F_OK) != 0 && errno == ENOENT) folder = folder.parent_path();
  if (::access((folder / "").c_str(), W_OK | X_OK) != 0) fail(name, "write", errno);
}

std::string read_whole(const std::string& path) try {
  std::error_code error;
  if (fs::is_character_file(path, error)) throw std::runtime_error(path + ": cannot read: it is a device, which need not end");
  std::ifstream in(path, std::ios::binary);
  if (!in) fail(path, "read", errno);
  return {std::istreambuf_iterator<char>(in), {}};
} catch (const std::ios_base::failure& e) {  // of a folder, or a broken disk
  throw std::runtime_error(path + ": cannot read: " + e.what());
}

}  // namespace refitlab
