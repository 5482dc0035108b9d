// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/weights.hpp"

namespace proptests::gen {

rc::Gen<std::vector<Rational>> convex_weights(int n) {
  const auto part = rc::gen::weightedOneOf<int>({{1, rc::gen::just(0)}, {2, small_positive_integer()}});
  return rc::gen::apply(
      [n](const std::vector<int>& parts, int weight_vertex) {
        std::vector<Rational> w(n, Rational(0));
        int sum = 0;
        for (const int p : parts) sum += p;
        if (sum == 0 || weight_vertex == 9) w[static_cast<std::size_t>(parts[0] + sum) % n] = 1;
        else
          for (int i = 0; i < n; ++i) w[i] = Rational(parts[i], sum);
        return w;
      },
      rc::gen::container<std::vector<int>>(n, part), rc::gen::inRange(0, 10));
}

}  // namespace proptests::gen
