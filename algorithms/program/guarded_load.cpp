// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/program/guarded_load.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "algorithms/model/assimp_scene.hpp"
#include "algorithms/model/gltf_scene.hpp"
#include "algorithms/model/load.hpp"
#include "algorithms/model/regular_file.hpp"
#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

Model load_model_guarded(const std::string& path, const LoadOptions& options, unsigned seconds) {
  const DefaultFloatEnvironment environment;
  const auto bytes = bytes_of_regular_file(path);
  if (!bytes || is_gltf(*bytes, path)) return load_model(path, options);
  const pid_t copy = fork();
  if (copy < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (copy == 0) {
    alarm(seconds);  // whose signal ends the copy
    try {
      assimp_scene(path);
    } catch (...) {
    }
    _exit(0);  // without the parent's buffers and destructors
  }
  int status = 0;
  while (waitpid(copy, &status, 0) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw ModelError(path, "file", "assimp crashes on it, or does not end");
  return load_model(path, options);
}

}  // namespace refitlab
