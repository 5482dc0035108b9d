// SPDX-License-Identifier: GPL-3.0-or-later
// Says whether an action throws an error of this kind.
#pragma once

namespace proptests::gen {

template <class Error, class Action>
bool refuses(const Action& action) {
  try {
    action();
  } catch (const Error&) {
    return true;
  }
  return false;
}

}  // namespace proptests::gen
