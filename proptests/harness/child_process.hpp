// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a copy of this process that does something until it is done or killed.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <stdexcept>

namespace proptests {

class ChildProcess {
 public:
  explicit ChildProcess(const std::function<void()>& work) : id_(fork()) {
    if (id_ < 0) throw std::runtime_error("cannot fork");
    if (id_ != 0) return;
    try {
      work();
    } catch (...) {
      _exit(1);
    }
    _exit(0);  // This ends it without the parent's buffers and destructors.
  }
  ~ChildProcess() { kill_now(); }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Kills it as kill -9 does. Does nothing to one that has ended.
  void kill_now() {
    if (ended_) return;
    ::kill(id_, SIGKILL);
    wait();
  }
  // Waits for it, and says whether it got to its end without throwing.
  bool wait() {
    int status = 0;
    if (!ended_ && waitpid(id_, &status, 0) == id_) ended_ = true, good_ = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    return good_;
  }
  int id() const { return id_; }

 private:
  pid_t id_;
  bool ended_ = false, good_ = false;
};

}  // namespace proptests
