// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/channel_value.hpp"

#include <algorithm>

#include "algorithms/runtime/packs/float_environment.hpp"
#include "lemmas/c2_channel_motion.hpp"

namespace refitlab {
namespace {

Eigen::Vector3d between(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double t) { return a + t * (b - a); }
Eigen::VectorXd between(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double t) { return a + t * (b - a); }
Eigen::Quaterniond between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b, double t) {
  return a.slerp(t, b).normalized();
}

// Evaluates the channel's spline from a key to the next.
template <int D, class Value, class Coefficients>
Vec<double, D> on_spline(const Channel<Value>& channel, std::size_t key, double share, const Coefficients& of) {
  const Key<Value>&a = channel.keys[key], &b = channel.keys[key + 1];
  return spline_curve<double, D>(of(a.value), of(channel.tangents[key].out), of(channel.tangents[key + 1].into), of(b.value),
                                 b.time - a.time)
      .at(share);
}
Eigen::Vector3d on_spline(const Channel<Eigen::Vector3d>& channel, std::size_t key, double share) {
  return on_spline<3>(channel, key, share, [](const Eigen::Vector3d& v) { return v; });
}
Eigen::VectorXd on_spline(const Channel<Eigen::VectorXd>& channel, std::size_t key, double share) {
  return on_spline<Eigen::Dynamic>(channel, key, share, [](const Eigen::VectorXd& v) { return v; });
}
Eigen::Quaterniond on_spline(const Channel<Eigen::Quaterniond>& channel, std::size_t key, double share) {
  const auto coefficients = [](const Eigen::Quaterniond& q) -> Eigen::Vector4d { return q.coeffs(); };
  return Eigen::Quaterniond(on_spline<4>(channel, key, share, coefficients)).normalized();
}

// Returns the value of the channel where it stays at a key.
Eigen::Vector3d at_key(const Eigen::Vector3d& v, Interpolation) { return v; }
Eigen::VectorXd at_key(const Eigen::VectorXd& v, Interpolation) { return v; }
Eigen::Quaterniond at_key(const Eigen::Quaterniond& q, Interpolation interpolation) {
  return interpolation == Interpolation::cubic ? q.normalized() : q;
}

template <class Value>
Value channel_value(const Channel<Value>& channel, double time, Side side) {
  const auto& keys = channel.keys;
  const auto after = side == Side::after
                         ? std::upper_bound(keys.begin(), keys.end(), time, [](double t, const auto& k) { return t < k.time; })
                         : std::lower_bound(keys.begin(), keys.end(), time, [](const auto& k, double t) { return k.time < t; });
  if (after == keys.begin()) return at_key(keys.front().value, channel.interpolation);
  if (after == keys.end() || channel.interpolation == Interpolation::step)
    return at_key((after - 1)->value, channel.interpolation);
  const auto before = after - 1;
  const double share = (time - before->time) / (after->time - before->time);
  if (channel.interpolation == Interpolation::cubic) return on_spline(channel, std::size_t(before - keys.begin()), share);
  return between(before->value, after->value, share);
}

}  // namespace

Eigen::Vector3d value_at(const Channel<Eigen::Vector3d>& channel, double time, Side side) {
  const DefaultFloatEnvironment environment;
  return channel_value(channel, time, side);
}

Eigen::Quaterniond value_at(const Channel<Eigen::Quaterniond>& channel, double time, Side side) {
  const DefaultFloatEnvironment environment;
  return channel_value(channel, time, side);
}

Eigen::VectorXd value_at(const Channel<Eigen::VectorXd>& channel, double time, Side side) {
  const DefaultFloatEnvironment environment;
  return channel_value(channel, time, side);
}

}  // namespace refitlab
