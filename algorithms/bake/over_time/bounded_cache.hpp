// SPDX-License-Identifier: GPL-3.0-or-later
// A BoundedCache keeps what several threads compute and share. If it has a limit, values beyond that number are computed again
// each time.
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <mutex>

namespace refitlab {

template <class Key, class Value>
class BoundedCache {
 public:
  explicit BoundedCache(std::size_t most = std::numeric_limits<std::size_t>::max()) : most_(most) {}

  // Returns the known value of the key, or what `make()` returns.
  template <class Make>
  std::shared_ptr<const Value> get(const Key& key, const Make& make) {
    {
      const std::lock_guard lock(guard_);
      if (const auto found = known_.find(key); found != known_.end()) return found->second;
    }
    auto made = std::make_shared<const Value>(make());
    const std::lock_guard lock(guard_);
    if (known_.size() < most_) return known_.try_emplace(key, std::move(made)).first->second;
    return made;
  }

 private:
  std::size_t most_;
  std::mutex guard_;
  std::map<Key, std::shared_ptr<const Value>> known_;
};

}  // namespace refitlab
