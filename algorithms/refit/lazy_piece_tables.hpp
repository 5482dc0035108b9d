// LazyPieceTables: the piece tables of a character, each made when it is first asked for: they take longer to make than
// the tree, and one variant needs one of them.
#pragma once

#include <array>
#include <atomic>
#include <mutex>
#include <optional>

#include "algorithms/refit/variants.hpp"
#include "algorithms/tree/pieces.hpp"

namespace refitlab {

class LazyPieceTables {
 public:
  // The table of a kind; make() makes it. Thread-safe: others that ask for it meanwhile wait. If make throws, so does
  // this, and the next one to ask makes it.
  template <class Make>
  const PieceTable& get(Pieces kind, Make&& make) {
    Table& table = tables_[static_cast<std::size_t>(kind)];
    if (!table.is_made.load(std::memory_order_acquire)) {
      const std::scoped_lock lock(mutex_);
      if (!table.pieces) table.pieces.emplace(make());
      table.is_made.store(true, std::memory_order_release);
    }
    return *table.pieces;
  }

 private:
  struct Table {
    std::atomic<bool> is_made = false;
    std::optional<PieceTable> pieces;
  };
  std::mutex mutex_;
  std::array<Table, piece_kinds> tables_;
};

}  // namespace refitlab
