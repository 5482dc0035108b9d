// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/draw.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithms/bake/parallel.hpp"
#include "experiments/render/caster.hpp"

namespace refitlab::render {
namespace {

constexpr double golden_angle = std::numbers::pi * 0.7639320225002103;  // (3 - sqrt 5) pi

// Returns the sRGB encoding. Above its straight part it comes from square roots, to within 0.001, because it is asked for three
// times a surface.
double to_srgb(double x) {
  if (x <= 0.0031308) return 12.92 * std::max(x, 0.0);
  const double y = std::min(x, 1.0), root2 = std::sqrt(y), root4 = std::sqrt(root2), root8 = std::sqrt(root4);
  return 0.662002687 * root2 + 0.684122060 * root4 - 0.323583601 * root8 - 0.0225411470 * y;
}

// Returns two unit vectors that complete the unit vector n to a frame.
Eigen::Matrix<double, 3, 2> tangents(const Point3& n) {
  const Point3 axis = std::abs(n.x()) < 0.6 ? Point3::UnitX() : Point3::UnitY();
  const Point3 t = n.cross(axis).normalized();
  Eigen::Matrix<double, 3, 2> plane;
  plane << t, n.cross(t);
  return plane;
}

constexpr int rays_each_way = 2, rays_of_pixel = rays_each_way * rays_each_way;

// A Pattern is a fixed set of points spread evenly over the unit disc (a sunflower), dealt out to the rays of a pixel.
class Pattern {
 public:
  // There are at least per_pixel points. Each ray gets as many as any other, and one or more.
  explicit Pattern(int per_pixel) : per_ray_((per_pixel + rays_of_pixel - 1) / rays_of_pixel), points_(rays_of_pixel * per_ray_) {
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const double side = std::sqrt((k + 0.5) / points_.size());
      points_[k] = {side * std::cos(golden_angle * k), side * std::sin(golden_angle * k)};
    }
  }
  // Returns the share of ray number `ray`'s points p for which open(p), with p turned by the rotation (cos, sin), is true.
  template <class Open>
  double share(int ray, const Vec<double, 2>& turn, const Open& open) const {
    int count = 0;
    for (int i = 0; i < per_ray_; ++i) {
      const auto& p = points_[i * rays_of_pixel + ray];
      count += open({p.x() * turn.x() - p.y() * turn.y(), p.x() * turn.y() + p.y() * turn.x()});
    }
    return double(count) / per_ray_;
  }

 private:
  int per_ray_;
  std::vector<Vec<double, 2>> points_;
};

class Shader {
 public:
  Shader(const Caster& caster, const Camera& camera, const Options& options)
      : caster_(caster),
        camera_(camera),
        options_(options),
        sky_pattern_(36),
        key_pattern_(9) {
    const auto towards = [&](double right, double up, double back) -> Point3 {
      return (right * camera.right() + up * camera.up() + back * camera.back()).normalized();
    };
    key_ = towards(-0.55, 0.75, 0.65);
    fill_ = towards(0.9, 0.05, 0.5);
    up_ = camera.up();
  }

  // Returns what a pixel's ray brings, as sRGB premultiplied by alpha, then alpha. Layers are composited in sRGB, as browsers lay
  // a transparent picture over a page. number is that of the ray in its pixel, and turn that of the sampling patterns in this
  // pixel.
  Eigen::Array4d trace(const Ray& ray, int number, const Vec<double, 2>& turn) const {
    const auto solid = caster_.nearest_opaque(ray);
    Eigen::Array4d sum = Eigen::Array4d::Zero();
    const auto put_under = [&](const Eigen::Array3d& linear, double opacity) {
      const double share = (1 - sum[3]) * opacity;
      sum += share * Eigen::Array4d(to_srgb(linear[0]), to_srgb(linear[1]), to_srgb(linear[2]), 1);
    };
    const double far = solid ? solid->distance : std::numeric_limits<double>::infinity();
    for (const Surface& s : caster_.translucent(ray, far)) {
      // A ball is a thin shell. The flatter it is seen, the more of it is in the way. Its far side is fainter.
      const double facing = std::max(0.3, std::abs(s.normal.dot(ray.direction)));
      const double face_on = s.opacity * (s.from_inside ? 0.3 : 1);
      const double opacity = face_on / (face_on + (1 - face_on) * facing);
      const double pixels_per_unit = options_.height / camera_.height();
      const double outline = std::clamp(options_.outline - s.inside_silhouette * pixels_per_unit + 0.5, 0.0, 1.0);
      if (!s.from_inside) put_under(0.35 * s.color, outline * std::max(0.75, s.opacity));
      put_under(light(s, ray, 1, 1), opacity);
    }
    if (solid) put_under(light(*solid, ray, sky_share(*solid, number, turn), key_share(*solid, number, turn)), 1);
    return sum;
  }

 private:
  // Returns the reflected light, linear. open is the share of the sky seen, and lit the share of the key light.
  Eigen::Array3d light(const Surface& s, const Ray& ray, double open, double lit) const {
    const double key = std::max(0.0, s.normal.dot(key_)) * lit;
    const double fill = 0.5 + 0.5 * s.normal.dot(fill_);
    const double sky = 0.5 + 0.5 * s.normal.dot(up_);
    double gloss = std::max(0.0, s.normal.dot((key_ - ray.direction).normalized()));
    for (int i = 0; i < 5; ++i) gloss *= gloss;
    return s.color * (0.66 * key + open * (0.16 * fill + 0.14 + 0.26 * sky)) + 0.05 * lit * gloss;
  }

  Point3 start(const Surface& s) const { return s.lifted + 2e-4 * caster_.diagonal() * s.face_normal; }

  // Returns the ambient occlusion, which is the share of a cosine-weighted hemisphere with nothing near.
  double sky_share(const Surface& s, int number, const Vec<double, 2>& turn) const {
    if (!options_.occlusion) return 1;
    const auto plane = tangents(s.normal);
    return sky_pattern_.share(number, turn, [&](const Vec<double, 2>& p) {
      const Point3 d = plane * p + std::sqrt(std::max(0.0, 1 - p.dot(p))) * s.normal;
      return d.dot(s.face_normal) <= 0 || !caster_.occluded(start(s), d, 0.25 * caster_.diagonal());
    });
  }

  // Returns the share of the key light, a disc 10 degrees in radius, that reaches the surface.
  double key_share(const Surface& s, int number, const Vec<double, 2>& turn) const {
    if (!options_.occlusion) return 1;
    if (s.normal.dot(key_) <= 0) return 0;
    const auto plane = tangents(key_);
    return key_pattern_.share(number, turn, [&](const Vec<double, 2>& p) {
      const Point3 d = key_ + 0.18 * plane * p;
      return !caster_.occluded(start(s), d.normalized(), 2 * caster_.diagonal());
    });
  }

  const Caster& caster_;
  const Camera& camera_;
  const Options& options_;
  Pattern sky_pattern_, key_pattern_;
  Point3 key_, fill_, up_;  // towards the lights and the sky
};

}  // namespace

Image draw(const Scene& scene, const Camera& camera, const Options& options) {
  scene.validate();
  Image image(options.width, options.height);
  const Caster caster(scene);
  const Shader shader(caster, camera, options);
  constexpr int n = rays_each_way;
  parallel_for(options.height, [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < options.width; ++x) {
      // By interleaved gradient noise (Jimenez 2014), neighbouring pixels turn the pattern by well spread angles.
      const double angle = 2 * std::numbers::pi * std::fmod(52.9829189 * std::fmod(0.06711056 * x + 0.00583715 * y, 1.0), 1.0);
      const Vec<double, 2> turn(std::cos(angle), std::sin(angle));
      Eigen::Array4d sum = Eigen::Array4d::Zero();
      for (int i = 0; i < rays_of_pixel; ++i) {
        // The grid is sheared, so that near-horizontal and near-vertical edges meet n * n different offsets, not n.
        const double across = (i % n + 0.5) / n, down = (i / n + 0.5) / n;
        const double px = x + across + (down - 0.5) / n, py = y + down - (across - 0.5) / n;
        const Ray ray = camera.ray((px - options.width / 2.0) / options.height, 0.5 - py / options.height);
        sum += shader.trace(ray, i, turn);
      }
      sum /= rays_of_pixel;
      sum += (1 - sum[3]) * Eigen::Array4d::Ones();  // the background
      std::uint8_t* pixel = image.pixel(x, y);
      for (int c = 0; c < 3; ++c) pixel[c] = std::lround(255 * std::min(1.0, sum[c]));
    }
  });
  return image;
}

}  // namespace refitlab::render
