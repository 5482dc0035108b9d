// Trying code that may crash, in a copy of the process.
#pragma once

#include <functional>

namespace refitlab {

// Whether f ends, by returning or throwing, within so many seconds, rather than bring the process down. It runs in a
// forked copy, of which nothing but this is left. Throws std::system_error where there can be no copy.
bool survives(const std::function<void()>& f, unsigned seconds = 600);

}  // namespace refitlab
