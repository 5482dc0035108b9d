// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/vector.hpp"

#include "proptests/gen/list.hpp"

namespace proptests::gen {
namespace {

template <int D>
rc::Gen<RationalVec<D>> any_vector(rc::Gen<Rational> component) {
  return rc::gen::map(rc::gen::container<std::vector<Rational>>(D, component), [](const std::vector<Rational>& c) {
    RationalVec<D> v;
    for (int i = 0; i < D; ++i) v[i] = c[i];
    return v;
  });
}

template <int D>
rc::Gen<RationalVec<D>> axis() {
  return rc::gen::apply(
      [](int i, bool negative) {
        RationalVec<D> v = RationalVec<D>::Zero();
        v[i] = negative ? -1 : 1;
        return v;
      },
      rc::gen::inRange(0, D), rc::gen::arbitrary<bool>());
}

}  // namespace

template <int D>
rc::Gen<RationalVec<D>> rational_vector() {
  const RationalVec<D> zero = RationalVec<D>::Zero();
  return rc::gen::weightedOneOf<RationalVec<D>>({{1, rc::gen::just(zero)}, {1, axis<D>()}, {8, any_vector<D>(rational())}});
}

template <int D>
rc::Gen<RationalVec<D>> nonzero_vector() {
  return rc::gen::suchThat(rational_vector<D>(),
                           [](const RationalVec<D>& v) { return refitlab::squared_norm(v) != Rational(0); });
}

template <int D>
rc::Gen<std::vector<RationalVec<D>>> vectors(int low, int high) {
  return list_with_repeats(low, high, rational_vector<D>());
}

template rc::Gen<RationalVec<1>> rational_vector<1>();
template rc::Gen<RationalVec<2>> rational_vector<2>();
template rc::Gen<RationalVec<3>> rational_vector<3>();
template rc::Gen<RationalVec<4>> rational_vector<4>();
template rc::Gen<RationalVec<1>> nonzero_vector<1>();
template rc::Gen<RationalVec<2>> nonzero_vector<2>();
template rc::Gen<RationalVec<3>> nonzero_vector<3>();
template rc::Gen<RationalVec<4>> nonzero_vector<4>();
template rc::Gen<std::vector<RationalVec<1>>> vectors<1>(int, int);
template rc::Gen<std::vector<RationalVec<2>>> vectors<2>(int, int);
template rc::Gen<std::vector<RationalVec<3>>> vectors<3>(int, int);
template rc::Gen<std::vector<RationalVec<4>>> vectors<4>(int, int);

}  // namespace proptests::gen
