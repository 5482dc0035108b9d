// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/explorer/packed_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

namespace refitlab {
namespace {

using nlohmann::json;

constexpr double poses_per_second = 24;
constexpr int most_steps = 120;
constexpr double weight_unit = 1. / (1 << 24);

template <class T>
json binary(const std::vector<T>& values) {
  std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
  std::memcpy(bytes.data(), values.data(), bytes.size());  // both machines are little-endian
  return json::binary(std::move(bytes));
}

template <class T>
std::vector<T> list(const json& j) {
  const auto& bytes = j.get_binary();
  if (bytes.size() % sizeof(T)) throw ModelError("packed model", "list", "it does not end with a whole number");
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

void add(std::vector<float>& to, const auto& from) {
  for (const double x : from) to.push_back(static_cast<float>(x));
}

json pack_clip(const Clip& clip) {
  const int steps = packed_steps(clip);
  std::vector<float> numbers;
  for (int i = 0; i <= steps; ++i)
    for (const auto& c : clip.sample(clip.duration * i / steps)) add(numbers, c.rotation), add(numbers, c.translation);
  return {{"name", clip.name}, {"duration", clip.duration}, {"poses", binary(numbers)}};
}

Clip unpack_clip(const json& j, std::size_t joints) {
  const auto numbers = list<float>(j.at("poses"));
  std::vector<Pose> poses(numbers.size() / std::max<std::size_t>(1, 7 * joints), Pose(joints));
  if (poses.empty()) throw ModelError("packed model", "clip", "it has no poses");
  const float* at = numbers.data();
  for (Pose& pose : poses)
    for (auto& c : pose) {
      for (int i = 0; i < 4; ++i) c.rotation[i] = *at++;
      for (int i = 0; i < 3; ++i) c.translation[i] = *at++;
      c.rotation /= c.rotation.norm();
    }
  const double duration = j.at("duration");
  const auto steps = static_cast<double>(poses.size() - 1);
  return {j.at("name"), duration, [poses, duration, steps](double t) {
            const double step = duration > 0 ? std::round(steps * t / duration) : 0;
            return poses[static_cast<std::size_t>(std::clamp(step, 0., steps))];
          }};
}

// The page asks for joints and clips by name, which files may give twice. What has the name of one before it gets its number,
// too.
void tell_apart(auto& things) {
  for (std::size_t i = 0; i < things.size(); ++i) {
    const auto own = things.begin() + static_cast<std::ptrdiff_t>(i);
    while (std::any_of(things.begin(), own, [&](const auto& thing) { return thing.name == own->name; }))
      own->name += " #" + std::to_string(i + 1);
  }
}

}  // namespace

int packed_steps(const Clip& clip) {
  return std::clamp(static_cast<int>(std::ceil(clip.duration * poses_per_second)), 1, most_steps);
}

std::vector<std::uint8_t> pack(const Model& m) {
  std::vector<float> vertices, origins;
  std::vector<int> triangles, parents, counts, joints, weights;
  json names = json::array(), clips = json::array();
  for (const Point3& v : m.vertices) add(vertices, v);
  for (const Triangle& t : m.triangles) triangles.insert(triangles.end(), t.begin(), t.end());
  for (const Joint& j : m.joints) names.push_back(j.name), parents.push_back(j.parent), add(origins, j.origin);
  for (const auto& influences : m.influences) {
    counts.push_back(static_cast<int>(influences.size()));
    for (const Influence& i : influences) joints.push_back(i.joint), weights.push_back(static_cast<int>(i.weight / weight_unit));
  }
  for (const Clip& clip : m.clips) clips.push_back(pack_clip(clip));
  return json::to_cbor({{"name", m.name},
                        {"vertices", binary(vertices)},
                        {"triangles", binary(triangles)},
                        {"names", names},
                        {"parents", binary(parents)},
                        {"origins", binary(origins)},
                        {"counts", binary(counts)},
                        {"joints", binary(joints)},
                        {"weights", binary(weights)},
                        {"clips", clips}});
}

Model unpack(const std::vector<std::uint8_t>& packed) {
  const json j = json::from_cbor(packed);
  const auto vertices = list<float>(j.at("vertices")), origins = list<float>(j.at("origins"));
  const auto triangles = list<int>(j.at("triangles")), parents = list<int>(j.at("parents")), counts = list<int>(j.at("counts")),
             joints = list<int>(j.at("joints")), weights = list<int>(j.at("weights"));
  const auto names = j.at("names").get<std::vector<std::string>>();
  if (parents.size() != names.size() || origins.size() != 3 * names.size() || joints.size() != weights.size() ||
      vertices.size() != 3 * counts.size())
    throw ModelError("packed model", "lists", "they do not fit each other");
  Model m;
  m.name = j.at("name");
  const auto point = [](const std::vector<float>& list, std::size_t i) {
    return Point3(list[3 * i], list[3 * i + 1], list[3 * i + 2]);
  };
  std::size_t next = 0;
  for (std::size_t v = 0; v < counts.size(); ++v) {
    m.vertices.push_back(point(vertices, v));
    m.influences.emplace_back();
    for (int i = 0; i < counts[v] && next < joints.size(); ++i, ++next)
      m.influences.back().push_back({joints[next], weights[next] * weight_unit});
  }
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
    m.triangles.push_back({triangles[i], triangles[i + 1], triangles[i + 2]});
  for (std::size_t i = 0; i < names.size(); ++i) m.joints.push_back({names[i], parents[i], point(origins, i)});
  for (const json& clip : j.at("clips")) m.clips.push_back(unpack_clip(clip, names.size()));
  tell_apart(m.joints), tell_apart(m.clips);
  validate(m);
  return m;
}

}  // namespace refitlab
