#include "algorithms/runtime/packs/four.hpp"

#include "proptests/harness.hpp"

namespace proptests {

PROPTEST(four) {
  t.example("a transposition makes the columns rows", {.number_type = "float"}, [] {
    refitlab::Four rows[4];
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k) rows[i][k] = static_cast<float>(4 * i + k);
    refitlab::transpose(rows);
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k)
        if (rows[i][k] != static_cast<float>(4 * k + i)) return false;
    return true;
  });
}

}  // namespace proptests
