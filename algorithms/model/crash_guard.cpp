#include "algorithms/model/crash_guard.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace refitlab {

bool survives(const std::function<void()>& f, unsigned seconds) {
  const pid_t copy = fork();
  if (copy < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (copy == 0) {
    alarm(seconds);  // whose signal ends the copy
    try {
      f();
    } catch (...) {
    }
    _exit(0);  // without the parent's buffers and destructors
  }
  int status = 0;
  while (waitpid(copy, &status, 0) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace refitlab
