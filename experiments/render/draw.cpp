#include "experiments/render/draw.hpp"

#include <numbers>
#include <stdexcept>

#include "experiments/render/caster.hpp"

namespace refitlab::render {
namespace {

using Array3 = Eigen::Array3d;
constexpr double golden_angle = std::numbers::pi * 0.7639320225002103;  // (3 - sqrt 5) pi

double to_srgb(double x) {
  const double y = std::clamp(x, 0.0, 1.0);
  return y <= 0.0031308 ? 12.92 * y : 1.055 * std::pow(y, 1 / 2.4) - 0.055;
}

// Two unit vectors that complete the unit vector n to a frame.
std::pair<Point3, Point3> tangents(const Point3& n) {
  const Point3 axis = std::abs(n.x()) < 0.6 ? Point3::UnitX() : Point3::UnitY();
  const Point3 t = n.cross(axis).normalized();
  return {t, n.cross(t)};
}

class Shader {
 public:
  Shader(const Caster& caster, const Camera& camera, const Options& options)
      : caster_(caster), camera_(camera), options_(options) {
    const auto towards = [&](double right, double up, double back) -> Point3 {
      return (right * camera.right() + up * camera.up() + back * camera.back()).normalized();
    };
    key_ = towards(-0.55, 0.75, 0.65);
    fill_ = towards(0.9, 0.05, 0.5);
    up_ = camera.up();
  }

  // What a pixel's ray brings, as sRGB premultiplied by alpha, then alpha: layers are composited in sRGB, because that is
  // how whoever lays a transparent picture over a page does it. sample, turn: which part of the sampling pattern is this
  // ray's, and by what share of a whole turn it is turned.
  Eigen::Array4d trace(const Ray& ray, int sample, double turn) const {
    const auto solid = caster_.nearest_opaque(ray);
    Eigen::Array4d sum = Eigen::Array4d::Zero();
    const auto put_under = [&](const Array3& linear, double opacity) {
      const double share = (1 - sum[3]) * opacity;
      sum += share * Eigen::Array4d(to_srgb(linear[0]), to_srgb(linear[1]), to_srgb(linear[2]), 1);
    };
    const double far = solid ? solid->distance : std::numeric_limits<double>::infinity();
    for (const Surface& s : caster_.translucent(ray, far)) {
      // A thin shell: the more of it in the way, the flatter it is seen. Its far side is fainter, to tell the two apart.
      const double facing = std::max(0.3, std::abs(s.normal.dot(ray.direction)));
      const double opacity = 1 - std::pow(1 - s.opacity * (s.from_inside ? 0.3 : 1), 0.6 / facing);
      const double pixels_per_unit = options_.height / camera_.extent(s.distance);
      const double outline = std::clamp(options_.outline - s.inside_silhouette * pixels_per_unit + 0.5, 0.0, 1.0);
      if (options_.outline > 0 && !s.from_inside) put_under(0.35 * s.color, outline * std::max(0.75, s.opacity));
      put_under(light(s, ray, 1, 1), opacity);
    }
    if (solid) put_under(light(*solid, ray, openness(*solid, sample, turn), shine(*solid, sample, turn)), 1);
    return sum;
  }

 private:
  static constexpr int occlusion_rays = 8, shadow_rays = 2;  // per ray of a pixel

  // Reflected light, linear. open: the share of the sky seen; lit: the share of the key light.
  Array3 light(const Surface& s, const Ray& ray, double open, double lit) const {
    const double key = std::max(0.0, s.normal.dot(key_)) * lit;
    const double fill = 0.5 + 0.5 * s.normal.dot(fill_);
    const double sky = 0.5 + 0.5 * s.normal.dot(up_);
    const Point3 half = (key_ - ray.direction).normalized();
    const double gloss = 0.05 * std::pow(std::max(0.0, s.normal.dot(half)), 30) * lit;
    return s.color * (0.62 * key + open * (0.16 * fill + 0.14 + 0.22 * sky)) + gloss;
  }

  Point3 start(const Surface& s) const { return s.lifted + 2e-4 * caster_.diagonal() * s.face_normal; }

  // Ambient occlusion: the share of a cosine-weighted hemisphere with nothing near.
  double openness(const Surface& s, int sample, double turn) const {
    if (!options_.occlusion) return 1;
    const auto [t, b] = tangents(s.normal);
    const int total = occlusion_rays * options_.supersampling * options_.supersampling;
    int open = 0;
    for (int i = 0; i < occlusion_rays; ++i) {
      const int k = i * (total / occlusion_rays) + sample;
      const double height = (k + 0.5) / total, angle = golden_angle * k + 2 * std::numbers::pi * turn;
      const double side = std::sqrt(height), up = std::sqrt(1 - height);
      const Point3 d = side * std::cos(angle) * t + side * std::sin(angle) * b + up * s.normal;
      open += d.dot(s.face_normal) <= 0 || !caster_.occluded(start(s), d, 0.25 * caster_.diagonal());
    }
    return double(open) / occlusion_rays;
  }

  // The share of the key light, a disc 10 degrees in radius, that reaches the surface.
  double shine(const Surface& s, int sample, double turn) const {
    if (!options_.occlusion) return 1;
    if (s.normal.dot(key_) <= 0) return 0;
    const auto [t, b] = tangents(key_);
    const int total = shadow_rays * options_.supersampling * options_.supersampling;
    int lit = 0;
    for (int i = 0; i < shadow_rays; ++i) {
      const int k = i * (total / shadow_rays) + sample;
      const double side = 0.18 * std::sqrt((k + 0.5) / total), angle = golden_angle * k + 2 * std::numbers::pi * turn;
      const Point3 d = key_ + side * (std::cos(angle) * t + std::sin(angle) * b);
      lit += !caster_.occluded(start(s), d.normalized(), 2 * caster_.diagonal());
    }
    return double(lit) / shadow_rays;
  }

  const Caster& caster_;
  const Camera& camera_;
  const Options& options_;
  Point3 key_, fill_, up_;  // towards the lights and the sky
};

}  // namespace

Image draw(const Scene& scene, const Camera& camera, const Options& options) {
  scene.validate();
  if (options.supersampling < 1 || options.supersampling > 8)
    throw std::invalid_argument("picture: supersampling must be in [1, 8]");
  Image image(options.width, options.height);
  const Caster caster(scene);
  const Shader shader(caster, camera, options);
  const int n = options.supersampling;
  for (int y = 0; y < options.height; ++y)
    for (int x = 0; x < options.width; ++x) {
      // Interleaved gradient noise (Jimenez 2014): neighbouring pixels turn the pattern by well spread angles.
      const double turn = std::fmod(52.9829189 * std::fmod(0.06711056 * x + 0.00583715 * y, 1.0), 1.0);
      Eigen::Array4d sum = Eigen::Array4d::Zero();
      for (int i = 0; i < n * n; ++i) {
        const double px = x + (i % n + 0.5) / n, py = y + (i / n + 0.5) / n;
        const Ray ray = camera.ray((px - options.width / 2.0) / options.height, 0.5 - py / options.height);
        sum += shader.trace(ray, i, turn);
      }
      sum /= n * n;
      if (!options.transparent) sum += (1 - sum[3]) * Eigen::Array4d::Ones();
      std::uint8_t* pixel = image.pixel(x, y);
      for (int c = 0; c < 3; ++c) pixel[c] = sum[3] > 0 ? std::lround(255 * std::min(1.0, sum[c] / sum[3])) : 0;
      pixel[3] = std::lround(255 * std::min(1.0, sum[3]));
    }
  return image;
}

}  // namespace refitlab::render
