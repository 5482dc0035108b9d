#include "algorithms/batch/refit_kernel.hpp"

#include <limits>

#include "algorithms/balls/mean_ball.hpp"
#include "algorithms/batch/rotation_bound_packs.hpp"
#include "algorithms/packs/by_joint.hpp"
#include "algorithms/packs/pack.hpp"
#include "algorithms/skinning/blend.hpp"

namespace refitlab::REFITLAB_TARGET {
namespace {

using S = Pack<float>;
constexpr int pack_size = static_cast<int>(S::size());
constexpr float epsilon = std::numeric_limits<float>::epsilon();

// The part of a block that one pack holds, read from the start on.
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

// The balls of one joint-set's corners: centers, and the radius that they share, without r.
struct CornerBalls {
  S* included;
  Vec<S, 3>* center;
  S radius;
};

struct Scratch {
  explicit Scratch(int corners) : included(corners), centers(corners), units(corners) {}
  std::vector<S> included;
  std::vector<Vec<S, 3>> centers;
  std::vector<Quaternion<S>> units;
};

// Algorithm 1 repaired. joints is how many the set has, or 0 if that is only known at run time.
struct Spherical {
  template <int joints>
  static void corner_balls(const BlockSet& set, const float* numbers, const Vec<S, 3>& p, Reader& read,
                           Quaternion<S>* units, CornerBalls& out) {
    const int n = joints ? joints : set.joint_count;
    ByJoint<RigidTransform<S>, joints> transforms(n);
    ByJoint<Vec<S, 3>, joints> center_images(n);
    ByJoint<S, joints> w(n);
    const Vec<S, 3> rotation_center = broadcast<3>(numbers);
    const S size(*numbers++);
    for (int i = 0; i < n; ++i) {
      transforms[i].rotation = broadcast<4>(numbers);
      center_images[i] = broadcast<3>(numbers);
    }
    const JointSetPose<S> pose{transforms, rotation_center, center_images, {}};
    const Vec<S, 3> x = p - rotation_center;
    const S length = norm(x);
    if (joints == 1) {  // one corner, and a quaternion of unit length
      out.included[0] = read(), read();
      out.center[0] = center_images[0] + rotate(transforms[0].rotation, x);
      out.radius = S(epsilon * 64) * (length + size);
      return;
    }
    Quaternion<S> direction(S(0), S(0), S(0), S(0));
    S longest_inverse(1);
    for (int k = 0; k < set.corner_count; ++k) {
      out.included[k] = read();
      for (int i = 0; i < n; ++i) w[i] = read();
      const std::span<const S> weights(w.data(), n);
      const Quaternion<S> blend = blend_quaternion(pose, weights);
      const S inverse = S(1) / root(squared_norm(blend));
      longest_inverse = max_of(longest_inverse, inverse);
      units[k] = blend * inverse;
      direction = direction + units[k] * out.included[k];
      out.center[k] = blend_center(pose, weights);
    }
    RotationBound<S> bound = bound_rotations_packs<float>(
        std::span<const Quaternion<S>>(units, set.corner_count), direction);
    const Vec<S, 3> offset = rotate(bound.apex, x) * bound.center_ratio;
    for (int k = 0; k < set.corner_count; ++k) out.center[k] = out.center[k] + offset;
    where(bound.center_ratio == S(0), longest_inverse) = S(1);  // of all rotations none is off
    out.radius = bound.radius_ratio * length + S(epsilon * float(64 + 2 * n)) * (length * longest_inverse + size);
  }
};

struct Linear {
  template <int joints>
  static void corner_balls(const BlockSet& set, const float* numbers, const Vec<S, 3>& p, Reader& read, Quaternion<S>*,
                           CornerBalls& out) {
    const int n = joints ? joints : set.joint_count;
    ByJoint<Vec<S, 3>, joints> images(n);
    ByJoint<S, joints> w(n);
    out.radius = S(*numbers++);
    for (int i = 0; i < n; ++i)
      for (int row = 0; row < 3; ++row) {
        const Vec<S, 3> r = broadcast<3>(numbers);
        images[i][row] = dot(r, p) + S(*numbers++);
      }
    for (int k = 0; k < set.corner_count; ++k) {
      out.included[k] = read();
      for (int i = 0; i < n; ++i) w[i] = read();
      out.center[k] = combine<S, 3>(std::span<const S>(w.data(), n), std::span<const Vec<S, 3>>(images.data(), n));
    }
  }
};

template <class Blending>
void corner_balls(const BlockSet& set, const FrameNumbers& frame, const Vec<S, 3>& p, Reader& read, Quaternion<S>* units,
                  CornerBalls& out) {
  const float* numbers = frame.numbers + frame.first[set.joint_set];
  switch (set.joint_count) {
    case 1: return Blending::template corner_balls<1>(set, numbers, p, read, units, out);
    case 2: return Blending::template corner_balls<2>(set, numbers, p, read, units, out);
    case 3: return Blending::template corner_balls<3>(set, numbers, p, read, units, out);
    case 4: return Blending::template corner_balls<4>(set, numbers, p, read, units, out);
    default: return Blending::template corner_balls<0>(set, numbers, p, read, units, out);
  }
}

void store(const S& x, Lanes<float>& to, int first) { x.copy_to(to.lane.data() + first, std::experimental::element_aligned); }

void store(const Vec<S, 3>& v, Lanes<float>* to, int first) {
  for (int i = 0; i < 3; ++i) store(v[i], to[i], first);
}

template <class Blending>
REFITLAB_KERNEL void refit_nodes(const NodeBlocks& all, const FrameNumbers& frame, Lanes<float>* out) {
  Scratch scratch(all.most_corners);
  CornerBalls of_set[most_sets_of_whole_nodes];
  for (const NodeBlock* block = all.blocks; block != all.blocks + all.block_count; ++block, out += 4)
    for (int first = 0; first < Lanes<float>::count; first += pack_size) {
      Reader read(all.data + block->first_data, first);
      const S px = read(), py = read(), pz = read(), r = read(), share = read();
      const Vec<S, 3> p(px, py, pz);
      Vec<S, 3> sum(S(0), S(0), S(0));
      int corners = 0;
      for (int e = 0; e < block->set_count; ++e) {
        const BlockSet& set = all.sets[block->first_set + e];
        CornerBalls& own = of_set[e] = {scratch.included.data() + corners, scratch.centers.data() + corners, S(0)};
        corner_balls<Blending>(set, frame, p, read, scratch.units.data(), own);
        for (int k = 0; k < set.corner_count; ++k) sum = sum + own.center[k] * own.included[k];
        corners += set.corner_count;
      }
      Vec<S, 3> center = sum;
      S radius = of_set[0].radius;
      if (corners > 1) {
        center = sum * share;
        radius = S(0);
        for (int e = 0; e < block->set_count; ++e) {
          const int m = all.sets[block->first_set + e].corner_count;
          const S far = farthest_squared_distance(center, std::span<const Vec<S, 3>>(of_set[e].center, m));
          radius = max_of(radius, S(root(far) + of_set[e].radius));
        }
      }
      store(center, out, first);
      store(S((radius + r) * S(1 + 8 * epsilon)), out[3], first);
    }
}

template <class Blending>
REFITLAB_KERNEL void refit_pieces(const NodeBlocks& all, const FrameNumbers& frame, Lanes<float>* out) {
  Scratch scratch(all.most_corners);
  for (const NodeBlock* block = all.blocks; block != all.blocks + all.block_count; ++block) {
    const BlockSet& set = all.sets[block->first_set];
    for (int first = 0; first < Lanes<float>::count; first += pack_size) {
      Reader read(all.data + block->first_data, first);
      const S px = read(), py = read(), pz = read();
      read(), read();  // r and the share, which only the merged node needs
      CornerBalls own{scratch.included.data(), scratch.centers.data(), S(0)};
      corner_balls<Blending>(set, frame, {px, py, pz}, read, scratch.units.data(), own);
      store(own.radius, out[0], first);
      for (int k = 0; k < set.corner_count; ++k) store(own.center[k], out + 1 + 3 * k, first);
    }
    out += 1 + 3 * set.corner_count;
  }
}

// The corners of one node after the other, as many at once as a pack has lanes.
REFITLAB_KERNEL void merge_nodes(const MergedNode* nodes, int node_count, const CornerPlace* corners, int most_corners,
                                 const float* pieces, float* balls) {
  constexpr int next = Lanes<float>::count;
  std::vector<float> gathered(4 * (most_corners + pack_size));
  float *const x = gathered.data(), *const y = x + most_corners + pack_size, *const z = y + most_corners + pack_size,
               *const r = z + most_corners + pack_size;
  for (const MergedNode* node = nodes; node != nodes + node_count; ++node) {
    const int count = node->corner_count;
    float sum[3] = {0, 0, 0};
    for (int k = 0; k < count; ++k) {
      const CornerPlace place = corners[node->first_corner + k];
      sum[0] += x[k] = pieces[place.center];
      sum[1] += y[k] = pieces[place.center + next];
      sum[2] += z[k] = pieces[place.center + 2 * next];
      r[k] = pieces[place.radius];
    }
    for (int k = count; k < count + pack_size; ++k) x[k] = x[0], y[k] = y[0], z[k] = z[0], r[k] = r[0];
    const float share = 1 / static_cast<float>(count);
    const Vec<S, 3> center(S(sum[0] * share), S(sum[1] * share), S(sum[2] * share));
    S radius = 0;
    for (int k = 0; k < count; k += pack_size) {
      const auto load = [k](const float* numbers) { return S(numbers + k, std::experimental::element_aligned); };
      const Vec<S, 3> corner(load(x), load(y), load(z));
      radius = max_of(radius, S(norm<S, 3>(corner - center) + load(r)));
    }
    float* ball = balls + node->place;
    for (int i = 0; i < 3; ++i) ball[i * next] = center[i][0];
    ball[3 * next] = (hmax(radius) + node->radius) * (1 + 8 * epsilon);
  }
}

}  // namespace

const RefitKernels refit_kernels{refit_nodes<Spherical>, refit_pieces<Spherical>, refit_nodes<Linear>, refit_pieces<Linear>,
                                 merge_nodes};

}  // namespace refitlab::REFITLAB_TARGET
