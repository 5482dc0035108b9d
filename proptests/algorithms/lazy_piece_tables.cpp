// A piece table is made once, however many threads ask at the same time, and anew after a failure.
#include "algorithms/refit/lazy_piece_tables.hpp"

#include <barrier>
#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>

#include "algorithms/model/procedural.hpp"
#include "algorithms/refit/character.hpp"
#include "proptests/harness.hpp"

namespace proptests {

using namespace refitlab;

namespace {

PieceTable make_table() {
  static const Character snake(make_snake(3));
  return PieceTable(snake.tree, snake.vertices, snake.model, snake.sets, {});
}

}  // namespace

PROPTEST(lazy_piece_tables) {
  t.example("threads that ask at the same time get one table, made once", {}, [] {
    constexpr int rounds = 50, threads = 8;
    for (int round = 0; round < rounds; ++round) {
      LazyPieceTables tables;
      std::atomic<int> made = 0;
      std::array<const PieceTable*, threads> found{};
      std::barrier together(threads);
      {
        std::vector<std::jthread> all;
        for (int i = 0; i < threads; ++i)
          all.emplace_back([&, i] {
            together.arrive_and_wait();
            found[i] = &tables.get(Pieces::mixed, [&] {
              ++made;
              std::this_thread::sleep_for(std::chrono::microseconds(200));  // long enough for others to come
              return make_table();
            });
          });
      }
      if (made != 1 || std::set<const PieceTable*>(found.begin(), found.end()).size() != 1)
        return Checked(false, round, "made " + std::to_string(made.load()) + " times");
    }
    return Checked(true, rounds, std::to_string(threads) + " threads each");
  });
  t.example("kinds have tables of their own", {}, [] {
    LazyPieceTables tables;
    const PieceTable& clusters = tables.get(Pieces::clusters, [] { return make_table(); });
    return &tables.get(Pieces::mixed, [] { return make_table(); }) != &clusters &&
           &tables.get(Pieces::clusters, []() -> PieceTable { throw std::logic_error("made twice"); }) == &clusters;
  });
  t.example("a table that could not be made is made by the next who asks", {}, [] {
    LazyPieceTables tables;
    bool failed = false;
    try {
      tables.get(Pieces::mixed, []() -> PieceTable { throw std::bad_alloc(); });
    } catch (const std::bad_alloc&) {
      failed = true;
    }
    int made = 0;
    tables.get(Pieces::mixed, [&] { return ++made, make_table(); });
    return failed && made == 1;
  });
}

}  // namespace proptests
