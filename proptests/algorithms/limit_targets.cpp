// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that a program can do without the wider targets. What it does to itself is tried in processes of their own.
#include "algorithms/runtime/packs/limit_targets.hpp"

#include <algorithm>
#include <stdexcept>

#include "proptests/gen/refuses.hpp"
#include "proptests/harness/child_process.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_limit_targets {
namespace {

using namespace refitlab;

// Says whether a process that limits itself to a target has all narrower targets and this one, and none that is wider, after it has
// refused a target that is not there.
bool is_limited_to(Target widest) {
  const std::vector<Target> before = available_targets();
  ChildProcess child([&] {
    limit_targets(widest);
    const std::vector<Target>& left = available_targets();
    bool is_right =
        best_target() == widest && left.size() <= before.size() && std::equal(left.begin(), left.end(), before.begin());
    for (const Target target : before)
      if (target > widest) is_right = is_right && gen::refuses<std::invalid_argument>([&] { limit_targets(target); });
    if (!is_right || available_targets().back() != widest) throw std::logic_error(name_of(widest));
  });
  return child.wait();
}

}  // namespace

PROPTEST(limit_targets) {
  t.example("of the targets of this processor, those up to any one are left, and the others are refused", {}, [] {
    bool are_right = true;
    for (const Target target : available_targets()) are_right = are_right && is_limited_to(target);
    return Checked(are_right, static_cast<long>(available_targets().size()), name_of(best_target()));
  });
  t.example("a target that is not there is refused, and those that are stay", {}, [] {
    const std::vector<Target> before = available_targets();
    return gen::refuses<std::invalid_argument>([] { limit_targets(static_cast<Target>(7)); }) && available_targets() == before;
  });
}

}  // namespace proptests::suite_limit_targets
