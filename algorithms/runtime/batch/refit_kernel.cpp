// SPDX-License-Identifier: MIT
#include "algorithms/runtime/batch/refit_kernel.hpp"

#include <limits>

#include "algorithms/runtime/balls/mean_ball.hpp"
#include "algorithms/runtime/packs/by_joint.hpp"
#include "algorithms/runtime/packs/pack.hpp"
#include "algorithms/runtime/packs/transpose.hpp"
#include "algorithms/runtime/skinning/blend.hpp"
#include "lemmas/rotation_bound.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

using S = Pack<float>;
constexpr int pack_size = static_cast<int>(S::size());
using PackOfFour = Pack<float, 4>;
constexpr float beyond_float = std::numeric_limits<float>::infinity();

// A Reader reads the part of a block that one pack holds, from the start on.
class Reader {
 public:
  Reader(const Lanes<float>* data, int first_lane) : next_(data->lane.data() + first_lane) {}
  S operator()() {
    const S out(next_, std::experimental::element_aligned);
    next_ += Lanes<float>::count;
    return out;
  }

 private:
  const float* next_;
};

template <int D>
Vec<S, D> broadcast(const float*& numbers) {
  Vec<S, D> out;
  for (int i = 0; i < D; ++i) out[i] = S(*numbers++);
  return out;
}

// The balls of one joint-set's weight vertices have centers, which offset has yet to move, and one radius, without r. sum is that
// of the moved centers, without those that repeat others.
struct WeightVertexBalls {
  Vec<S, 3>* center;
  Vec<S, 3> offset, sum;
  S radius;
};

struct Scratch {
  explicit Scratch(int weight_vertices) : centers(weight_vertices), units(weight_vertices) {}
  std::vector<Vec<S, 3>> centers;
  std::vector<Quaternion<S>> units;
};

// Weights has the weights of one weight vertex. The last one is 1 less the sum of the others, which is exact.
template <int joints>
class Weights {
 public:
  explicit Weights(int count) : w_(count) {}
  std::span<const S> read(Reader& read) {
    const int last = static_cast<int>(w_.size()) - 1;
    S rest(1);
    for (int i = 0; i < last; ++i) {
      w_[i] = read();
      rest = rest - w_[i];
    }
    w_[last] = rest;
    return {w_.data(), joints ? joints : w_.size()};
  }

 private:
  ByJoint<S, joints> w_;
};

// Returns the bound of one unit quaternion, which is that rotation. If it is no number, all rotations are allowed.
RotationBound<S> bound_rotation(const Quaternion<S>& unit) {
  const auto is_rotation = is_certainly_nonzero(squared_norm(unit));
  return {choose(is_rotation, unit, identity_quaternion<S>()), choose(is_rotation, S(1), S(0)), choose(is_rotation, S(0), S(1))};
}

// This is Algorithm 1 repaired. joints and weight_vertices are how many the set has, or 0 if that is only known at run time.
struct Spherical {
  template <int joints, int weight_vertices>
  static void weight_vertex_balls(const BlockSet& set, const float* numbers, const Vec<S, 3>& p, const S&, Reader& read,
                                  Quaternion<S>* units, WeightVertexBalls& out) {
    const int n = joints ? joints : set.joint_count, m = weight_vertices ? weight_vertices : set.weight_vertex_count;
    ByJoint<RigidTransform<S>, joints> transforms(n);
    ByJoint<Vec<S, 3>, joints> center_images(n);
    Weights<joints> weights(n);
    const Vec<S, 3> rotation_center = broadcast<3>(numbers);
    const S size(*numbers++);
    for (int i = 0; i < n; ++i) {
      transforms[i].rotation = broadcast<4>(numbers);
      center_images[i] = broadcast<3>(numbers);
    }
    const Vec<S, 3> x = p - rotation_center;
    const S longer = (abs(x[0]) + abs(x[1])) + abs(x[2]);  // than x
    if (joints == 1) {                                     // one weight vertex, and a quaternion of unit length
      out.center[0] = center_images[0];
      out.offset = rotate(transforms[0].rotation, x);
      out.sum = center_images[0] + out.offset;
      out.radius = S(algorithm1_slack(1)) * (longer + size);
      return;
    }
    const PaletteEntry<S> palette{transforms, rotation_center, center_images, {}};
    Quaternion<S> direction(S(0), S(0), S(0), S(0));
    Vec<S, 3> sum(S(0), S(0), S(0));
    S longest_inverse(1), count(static_cast<float>(set.certain_weight_vertices));
    const auto place = [&](int k) {
      const std::span<const S> w = weights.read(read);
      const Quaternion<S> blend = blend_quaternion(palette, w);
      const S inverse = S(1) / root(squared_norm(blend));
      longest_inverse = max_of(longest_inverse, inverse);
      units[k] = blend * inverse;
      out.center[k] = blend_center(palette, w);
    };
    const auto turn = [&](const RotationBound<S>& bound) {
      const Ball3<S> turned = rotated_ball(bound, x);
      out.offset = turned.center;
      const S inverse = choose(bound.center_ratio == S(0), S(1), longest_inverse);  // of all rotations none is off
      out.radius = turned.radius + S(algorithm1_slack(n)) * (longer * inverse + size);
    };
    if (m == 1) {
      place(0);
      turn(bound_rotation(units[0]));
      out.sum = out.center[0] + out.offset;
      return;
    }
    for (int k = 0; k < set.certain_weight_vertices; ++k) {
      place(k);
      direction = direction + units[k];
      sum = sum + out.center[k];
    }
    for (int k = set.certain_weight_vertices; k < m; ++k) {
      const S included = read();
      place(k);
      direction = direction + units[k] * included;
      sum = sum + out.center[k] * included;
      count = count + included;
    }
    turn(bound_rotations<S>({units, static_cast<std::size_t>(m)}, direction));
    out.sum = sum + out.offset * count;
  }
};

struct Linear {
  template <int joints, int weight_vertices>
  static void weight_vertex_balls(const BlockSet& set, const float* numbers, const Vec<S, 3>& p, const S& r, Reader& read,
                                  Quaternion<S>*, WeightVertexBalls& out) {
    const int n = joints ? joints : set.joint_count, m = weight_vertices ? weight_vertices : set.weight_vertex_count;
    ByJoint<Vec<S, 3>, joints> images(n);
    Weights<joints> weights(n);
    const S slack(*numbers++), stretch(*numbers++);
    out.radius = slack + stretch * r;
    for (int i = 0; i < n; ++i)
      for (int row = 0; row < 3; ++row) {
        const Vec<S, 3> of_rotation = broadcast<3>(numbers);
        images[i][row] = dot(of_rotation, p) + S(*numbers++);
      }
    out.offset = out.sum = Vec<S, 3>(S(0), S(0), S(0));
    for (int k = 0; k < m; ++k) {
      const S included = k < set.certain_weight_vertices ? S(1) : read();
      out.center[k] = combine<S, 3>(weights.read(read), std::span<const Vec<S, 3>>(images.data(), n));
      out.sum = out.sum + out.center[k] * included;
    }
  }
};

template <class Blending>
void weight_vertex_balls(const BlockSet& set, const FrameNumbers& frame, const Vec<S, 3>& p, const S& r, Reader& read,
                         Quaternion<S>* units, WeightVertexBalls& out) {
  const float* numbers = frame.numbers + frame.first[set.joint_set];
  switch (set.joint_count) {
    case 1:
      if (set.weight_vertex_count == 1) return Blending::template weight_vertex_balls<1, 1>(set, numbers, p, r, read, units, out);
      break;  // others repeat it
    case 2:
      if (set.weight_vertex_count == 2) return Blending::template weight_vertex_balls<2, 2>(set, numbers, p, r, read, units, out);
      if (set.weight_vertex_count == 1) return Blending::template weight_vertex_balls<2, 1>(set, numbers, p, r, read, units, out);
      break;  // others are between two of them
    case 3: return Blending::template weight_vertex_balls<3, 0>(set, numbers, p, r, read, units, out);
    case 4: return Blending::template weight_vertex_balls<4, 0>(set, numbers, p, r, read, units, out);
    default: break;
  }
  return Blending::template weight_vertex_balls<0, 0>(set, numbers, p, r, read, units, out);
}

void store(const S& x, Lanes<float>& to, int first) { x.copy_to(to.lane.data() + first, std::experimental::element_aligned); }

void store(const Vec<S, 3>& v, Lanes<float>* to, int first) {
  for (int i = 0; i < 3; ++i) store(v[i], to[i], first);
}

// Head has the numbers of a block that come first.
struct Head {
  Vec<S, 3> p;
  S r, share;
  Head(const NodeBlock& block, Reader& read) {
    for (int i = 0; i < 3; ++i) p[i] = read();
    r = read();
    share = block.share > 0 ? S(block.share) : read();
  }
};

template <class Blending>
REFITLAB_KERNEL void refit_nodes(const NodeBlocks& all, const FrameNumbers& frame, Lanes<float>* out) {
  Scratch scratch(all.most_weight_vertices);
  WeightVertexBalls of_set[most_sets_of_whole_nodes];
  for (const NodeBlock* block = all.blocks; block != all.blocks + all.block_count; ++block, out += 4)
    for (int first = 0; first < Lanes<float>::count; first += pack_size) {
      Reader read(all.data + block->first_data, first);
      const auto [p, r, share] = Head(*block, read);
      Vec<S, 3> sum(S(0), S(0), S(0));
      int weight_vertices = 0;
      for (int e = 0; e < block->set_count; ++e) {
        const BlockSet& set = all.sets[block->first_set + e];
        WeightVertexBalls& own = of_set[e];
        own.center = scratch.centers.data() + weight_vertices;
        weight_vertex_balls<Blending>(set, frame, p, r, read, scratch.units.data(), own);
        sum = sum + own.sum;
        weight_vertices += set.weight_vertex_count;
      }
      Vec<S, 3> center = sum;
      S radius = of_set[0].radius;
      if (weight_vertices > 1) {
        center = sum * share;
        radius = S(-beyond_float);  // joints that shrink have negative ones
        for (int e = 0; e < block->set_count; ++e) {
          const int m = all.sets[block->first_set + e].weight_vertex_count;
          const std::span<const Vec<S, 3>> centers(of_set[e].center, m);
          const S far = farthest_squared_distance<S, 3>(center - of_set[e].offset, centers);
          radius = max_of(radius, S(root(far) + of_set[e].radius));
        }
      }
      store(center, out, first);
      // An infinite radius stays so, where what joints that shrink add to it is not a number.
      const S grown = (radius + r) * S(refit_radius_stretch) + S(underflow_slack);
      store(choose(r < S(beyond_float), grown, r), out[3], first);
    }
}

template <class Blending>
REFITLAB_KERNEL void refit_pieces(const NodeBlocks& all, const FrameNumbers& frame, Row<float, 4>* records) {
  Scratch scratch(all.most_weight_vertices);
  for (const NodeBlock* block = all.blocks; block != all.blocks + all.block_count; ++block) {
    const BlockSet& set = all.sets[block->first_set];
    for (int first = 0; first < Lanes<float>::count; first += pack_size) {
      Reader read(all.data + block->first_data, first);
      const Head head(*block, read);
      WeightVertexBalls own;
      own.center = scratch.centers.data();
      weight_vertex_balls<Blending>(set, frame, head.p, head.r, read, scratch.units.data(), own);
      const PieceTarget* targets = all.targets + block->first_target + first;
      for (int k = 0; k < set.weight_vertex_count; ++k) {
        alignas(64) float numbers[4][pack_size];
        for (int i = 0; i < 3; ++i) S(own.center[k][i] + own.offset[i]).copy_to(numbers[i], std::experimental::vector_aligned);
        own.radius.copy_to(numbers[3], std::experimental::vector_aligned);
        for (int lane = 0; lane < pack_size; lane += 4) {
          Row<float, 4> rows[4];
          for (int i = 0; i < 4; ++i) read_row(numbers[i] + lane, rows[i]);
          transpose(rows);
          for (int i = 0; i < 4; ++i) {  // a lane that has no such weight vertex repeats its last one
            const PieceTarget& target = targets[lane + i];
            records[target.first + k < target.last ? target.first + k : target.last] = rows[i];
          }
        }
      }
    }
  }
}

REFITLAB_KERNEL void merge_nodes(const MergedNode* nodes, int node_count, const Row<float, 4>* records, float* balls) {
  for (const MergedNode* node = nodes; node != nodes + node_count; ++node) {
    const Row<float, 4>* own = records + node->first_record;
    Row<float, 4> sums[4] = {own[0], own[1], own[2], own[3]};  // records that fill up have a center of zero
    for (int k = 4; k < node->weight_vertex_count; k += 4)
      for (int i = 0; i < 4; ++i) sums[i] += own[k + i];
    const Row<float, 4> sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    const float share = 1 / static_cast<float>(node->weight_vertex_count);
    const float center[3] = {sum[0] * share, sum[1] * share, sum[2] * share};
    PackOfFour radius = -beyond_float;  // joints that shrink have negative ones
    for (int k = 0; k < node->weight_vertex_count; k += 4) {
      Row<float, 4> rows[4] = {own[k], own[k + 1], own[k + 2], own[k + 3]};
      transpose(rows);
      PackOfFour squared = 0;
      for (int i = 0; i < 3; ++i) {
        const PackOfFour d = PackOfFour(rows[i]) - center[i];
        squared += d * d;
      }
      radius = max(radius, sqrt(squared) + PackOfFour(rows[3]));
    }
    float* ball = balls + node->place;
    for (int i = 0; i < 3; ++i) ball[i * Lanes<float>::count] = center[i];
    const float grown = (hmax(radius) + node->radius) * refit_radius_stretch + underflow_slack;
    ball[3 * Lanes<float>::count] = node->radius < beyond_float ? grown : node->radius;
  }
}

}  // namespace

const RefitKernels refit_kernels{refit_nodes<Spherical>, refit_nodes<Linear>, refit_pieces<Spherical>, refit_pieces<Linear>,
                                 merge_nodes};

}  // namespace refitlab::REFITLAB_TARGET
