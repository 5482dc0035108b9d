// SPDX-License-Identifier: GPL-3.0-or-later
// A RunFolder keeps the finished units of a run, so that a run that was stopped resumes where it was.
#pragma once

#include <optional>
#include <string>

#include "experiments/resume/folder_lock.hpp"

namespace refitlab {

// A unit is a piece of work with a name, such as an experiment on a model. Its file says what made it: the provenance
// of this build, the program itself (by fingerprint) and the inputs. It counts only if all of that is the same again,
// and its result is undamaged. The folder is held by one run at a time.
class RunFolder {
 public:
  // If anew is true, all units are forgotten. Throws std::runtime_error if the folder is in use or cannot be written.
  explicit RunFolder(const std::string& folder, bool anew = false);

  // Returns the result of a unit that this very program made from these inputs, or nothing. inputs are options and whatever else
  // the result depends on, as text.
  std::optional<std::string> find(const std::string& unit, const std::string& inputs) const;
  // Keeps the result of a unit from now on, in place of an older one of that name.
  void keep(const std::string& unit, const std::string& inputs, const std::string& result) const;

 private:
  std::string path(const std::string& unit) const;
  std::string folder_;
  FolderLock lock_;
};

}  // namespace refitlab
