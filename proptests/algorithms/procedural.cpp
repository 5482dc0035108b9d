// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the built-in models: their sizes, that the skin is one closed surface, its weights, and the two clips.
#include "experiments/procedural/procedural.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "algorithms/runtime/skinning/skinning_palette.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_procedural {
namespace {

using namespace refitlab;

struct Expected {
  Model (*make)();
  std::size_t triangles, joints;
  // These are the limits of the skin, in metres above the ground.
  double low, high;
  std::vector<std::string> twisted;
};

const std::vector<Expected> all_expected = {
    {make_man, 8270, 27, 0, 1.8, {"waist", "neck", "left_upper_arm", "right_upper_arm"}},
    {make_creature, 13590, 56, 0, 2.05, {"neck_3", "tail_2", "left_upper_arm", "right_wing_arm"}}};

const std::vector<Model>& models() {
  static const std::vector<Model> made = [] {
    std::vector<Model> list;
    for (const Expected& e : all_expected) list.push_back(e.make());
    return list;
  }();
  return made;
}

Checked for_each_model(const std::function<Checked(const Model&, const Expected&)>& check) {
  Checked all(true, 0);
  for (std::size_t i = 0; i < models().size(); ++i) {
    const Checked one = check(models()[i], all_expected[i]);
    all.passed = all.passed && one.passed;
    all.cases += one.cases;
    all.detail += (i > 0 ? "; " : "") + models()[i].name + ": " + one.detail;
  }
  return all;
}

// Returns the directed edges a -> b of the triangles.
std::multiset<std::pair<int, int>> directed_edges(const Model& m) {
  std::multiset<std::pair<int, int>> edges;
  for (const Triangle& t : m.triangles)
    for (int k = 0; k < 3; ++k) edges.insert({t[k], t[(k + 1) % 3]});
  return edges;
}

// Says whether every edge belongs to two triangles that run through it in opposite directions.
bool is_closed_and_oriented(const Model& m) {
  const auto edges = directed_edges(m);
  return std::all_of(edges.begin(), edges.end(), [&](const std::pair<int, int>& e) {
    return edges.count(e) == 1 && edges.count({e.second, e.first}) == 1;
  });
}

// Says whether the triangles around each vertex form one ring. (With the edges' property, the surface is then a manifold.)
bool has_one_ring_a_vertex(const Model& m) {
  // Entry v leads around v from one neighbour to the next.
  std::vector<std::map<int, int>> next(m.vertices.size());
  for (const Triangle& t : m.triangles)
    for (int k = 0; k < 3; ++k) next[t[k]][t[(k + 1) % 3]] = t[(k + 2) % 3];
  for (const auto& ring : next) {
    if (ring.empty()) return false;
    std::size_t length = 1;
    const int first = ring.begin()->first;
    for (int at = ring.begin()->second; at != first && ring.contains(at) && length <= ring.size(); ++length) at = ring.at(at);
    if (length != ring.size()) return false;
  }
  return true;
}

std::size_t component_count(const Model& m) {
  std::vector<int> parent(m.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root_of = [&](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : m.triangles)
    for (int k = 1; k < 3; ++k) parent[root_of(t[0])] = root_of(t[k]);
  std::set<int> roots;
  for (std::size_t v = 0; v < parent.size(); ++v) roots.insert(root_of(static_cast<int>(v)));
  return roots.size();
}

bool crosses_itself(const Model& m) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  for (const Point3& p : m.vertices) mesh.add_vertex({p[0], p[1], p[2]});
  for (const auto& [a, b, c] : m.triangles)
    mesh.add_face(CGAL::SM_Vertex_index(a), CGAL::SM_Vertex_index(b), CGAL::SM_Vertex_index(c));
  return CGAL::Polygon_mesh_processing::does_self_intersect(mesh);
}

double volume(const Model& m) {
  double sum = 0;
  for (const auto& [a, b, c] : m.triangles) sum += dot(m.vertices[a], cross(m.vertices[b], m.vertices[c])) / 6;
  return sum;
}

// Returns the smallest angle of a triangle, in degrees.
double smallest_angle(const Model& m, const Triangle& t) {
  double smallest = 180;
  for (int k = 0; k < 3; ++k) {
    const Point3 to_next = m.vertices[t[(k + 1) % 3]] - m.vertices[t[k]];
    const Point3 to_last = m.vertices[t[(k + 2) % 3]] - m.vertices[t[k]];
    const double angle = std::atan2(norm(cross(to_next, to_last)), dot(to_next, to_last));
    smallest = std::min(smallest, angle * 180 / std::numbers::pi);
  }
  return smallest;
}

double weight_of(const Model& m, int vertex, int joint) {
  for (const Influence& i : m.influences[vertex])
    if (i.joint == joint) return i.weight;
  return 0;
}

// Returns the largest change of a weight between the ends of an edge.
double largest_weight_step(const Model& m) {
  double largest = 0;
  for (const auto& [a, b] : directed_edges(m))
    for (const Influence& i : m.influences[a]) largest = std::max(largest, std::abs(i.weight - weight_of(m, b, i.joint)));
  return largest;
}

const Clip& clip(const Model& m, const std::string& name) {
  return *std::find_if(m.clips.begin(), m.clips.end(), [&](const Clip& c) { return c.name == name; });
}

// Returns the largest absolute difference of a component. Rotations are compared with their signs.
double difference(const Pose& a, const Pose& b) {
  double largest = 0;
  for (std::size_t j = 0; j < a.size(); ++j) {
    const Quaternion<double> turned = a[j].rotation - b[j].rotation;
    const Point3 moved = a[j].translation - b[j].translation;
    largest = std::max({largest, turned.cwiseAbs().maxCoeff(), moved.cwiseAbs().maxCoeff()});
  }
  return largest;
}

// Returns the angle in degrees, in [0, 180], by which a joint is turned against its parent.
double turned_against_parent(const Model& m, const Pose& pose, int joint) {
  const Quaternion<double> relative = multiply(conjugate(pose[m.joints[joint].parent].rotation), pose[joint].rotation);
  return 2 * std::atan2(norm(imaginary(relative)), std::abs(relative[0])) * 180 / std::numbers::pi;
}

int joint_named(const Model& m, const std::string& name) {
  for (std::size_t j = 0; j < m.joints.size(); ++j)
    if (m.joints[j].name == name) return static_cast<int>(j);
  throw std::runtime_error(m.name + " has no joint " + name);
}

bool same(const Model& a, const Model& b) {
  const auto same_influence = [](const Influence& x, const Influence& y) { return x.joint == y.joint && x.weight == y.weight; };
  const auto same_list = [&](const std::vector<Influence>& x, const std::vector<Influence>& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), same_influence);
  };
  return a.vertices == b.vertices && a.triangles == b.triangles &&
         std::equal(a.influences.begin(), a.influences.end(), b.influences.begin(), b.influences.end(), same_list);
}

// Returns times of a clip, its ends included.
std::vector<double> times_of(const Clip& c) {
  std::vector<double> times;
  for (int i = 0; i <= 24; ++i) times.push_back(c.duration * i / 24);
  return times;
}

void numbers_of_triangles_and_joints(Suite& t) {
  t.example("the models have the paper's numbers of triangles and joints, and names for all joints", {}, [] {
    return for_each_model([](const Model& m, const Expected& e) {
      std::set<std::string> names;
      for (const Joint& joint : m.joints) names.insert(joint.name);
      return Checked(
          m.triangles.size() == e.triangles && m.joints.size() == e.joints && names.size() == e.joints && !names.contains(""), 1,
          std::to_string(m.triangles.size()) + " triangles, " + std::to_string(names.size()) + " joints");
    });
  });

  t.example("a snake of any number of joints is one closed surface of 20,000 triangles with about as many joint-sets", {}, [] {
    long snakes = 0;
    for (const int joints : {1, 2, 7, 100, 1000}) {
      const Model m = make_snake(joints);
      const int sets = JointSets(m).count();
      const Pose pose = m.clips[0].sample(0.3);
      validate(m);
      if (m.triangles.size() != 20000 || static_cast<int>(m.joints.size()) != joints || !is_closed_and_oriented(m) ||
          component_count(m) != 1 || !(volume(m) > 0) || sets < joints || sets > 2 * joints || pose.size() != m.joints.size())
        return Checked(false, snakes, m.name);
      const JointSets in(m);
      // This throws for a pose that is not rigid.
      make_skinning_palette(m, in, pose, Skinning::spherical);
      ++snakes;
    }
    try {
      make_snake(0);
    } catch (const ModelError& e) {
      return Checked(std::string(e.what()).find("joints") != std::string::npos, snakes, e.what());
    }
    return Checked(false, snakes, "a snake without joints was made");
  });

  t.example("the models pass validation", {}, [] {
    return for_each_model([](const Model& m, const Expected&) {
      validate(m);
      return Checked(true);
    });
  });
}

void skins_are_closed_surfaces_of_good_triangles(Suite& t) {
  t.example("the skin is closed and consistently oriented, with one ring of triangles around each vertex", {}, [] {
    return for_each_model([](const Model& m, const Expected&) {
      return Checked(is_closed_and_oriented(m) && has_one_ring_a_vertex(m), long(m.vertices.size()));
    });
  });

  t.example("the skin is in one piece, has no handles, and faces outwards", {}, [] {
    return for_each_model([](const Model& m, const Expected&) {
      const long euler = long(m.vertices.size()) - long(m.triangles.size()) / 2;
      return Checked(component_count(m) == 1 && euler == 2 && volume(m) > 0, 1,
                     std::to_string(component_count(m)) + " pieces, Euler characteristic " + std::to_string(euler) + ", volume " +
                         std::to_string(volume(m)) + " m^3");
    });
  });

  t.example("the skin does not cross itself in the reference pose", {},
            [] { return for_each_model([](const Model& m, const Expected&) { return Checked(!crosses_itself(m), 1); }); });

  t.example("no triangle has an angle below 15 degrees, and few one below 30", {}, [] {
    return for_each_model([](const Model& m, const Expected&) {
      double smallest = 180;
      long sharp = 0;
      for (const Triangle& triangle : m.triangles) {
        const double angle = smallest_angle(m, triangle);
        smallest = std::min(smallest, angle);
        sharp += angle < 30;
      }
      return Checked(smallest > 15 && sharp < 0.01 * double(m.triangles.size()), long(m.triangles.size()),
                     std::to_string(smallest) + " degrees, " + std::to_string(sharp) + " below 30");
    });
  });

  t.example("the skin stands on the ground, is as tall as stated, and is about as wide on both sides", {}, [] {
    return for_each_model([](const Model& m, const Expected& e) {
      Point3 low = m.vertices[0], high = low;
      for (const Point3& p : m.vertices) low = low.cwiseMin(p), high = high.cwiseMax(p);
      return Checked(std::abs(low[1] - e.low) < 0.01 && std::abs(high[1] - e.high) < 0.02 && std::abs(low[0] + high[0]) < 0.02, 1,
                     "from " + std::to_string(low[1]) + " to " + std::to_string(high[1]) + " m");
    });
  });
}

void weights_of_joints(Suite& t) {
  t.example("a vertex has at most four joints, many have one, and weights change smoothly", {}, [] {
    return for_each_model([](const Model& m, const Expected&) {
      std::size_t most = 0;
      long single = 0;
      // This is the least weight: they fade out rather than end.
      double least = 1;
      for (const auto& list : m.influences) {
        most = std::max(most, list.size()), single += list.size() == 1;
        for (const Influence& i : list) least = std::min(least, i.weight);
      }
      const double step = largest_weight_step(m), share = double(single) / double(m.vertices.size());
      return Checked(most == 4 && share > 0.2 && step < 0.6 && least < 0.001, long(m.vertices.size()),
                     "largest step " + std::to_string(step) + ", one joint: " + std::to_string(share));
    });
  });

  t.example("every joint moves some vertex", {}, [] {
    return for_each_model([](const Model& m, const Expected&) {
      std::set<int> used;
      for (const auto& list : m.influences)
        for (const Influence& i : list) used.insert(i.joint);
      return Checked(used.size() == m.joints.size(), long(m.joints.size()));
    });
  });

  t.example("making a model twice gives the same model", {},
            [] { return for_each_model([](const Model& m, const Expected& e) { return Checked(same(m, e.make())); }); });
}

void clips_keep_joints_together_and_turn_smoothly(Suite& t) {
  t.example("every pose of a clip has unit quaternions and keeps joints together", {}, [] {
    return for_each_model([](const Model& m, const Expected&) {
      double worst_length = 0, worst_gap = 0;
      long cases = 0;
      for (const Clip& c : m.clips)
        for (const double time : times_of(c)) {
          const Pose pose = c.sample(time);
          for (std::size_t j = 0; j < m.joints.size(); ++j, ++cases) {
            worst_length = std::max(worst_length, std::abs(norm(pose[j].rotation) - 1));
            if (m.joints[j].parent < 0) continue;
            // A joint's origin is a point of its parent's bone: both take it to the same place.
            const Point3 by_parent = apply(pose[m.joints[j].parent], m.joints[j].origin);
            worst_gap = std::max(worst_gap, norm(Point3(apply(pose[j], m.joints[j].origin) - by_parent)));
          }
        }
      return Checked(m.clips.size() == 2 && worst_length < 1e-12 && worst_gap < 1e-12, cases);
    });
  });

  t.example("the twist begins in the reference pose", {}, [] {
    return for_each_model(
        [](const Model& m, const Expected&) { return Checked(difference(clip(m, "twist").sample(0), reference_pose(m)) == 0); });
  });

  t.example("the twist ends with half a turn at the named joints, and none at others", {}, [] {
    return for_each_model([](const Model& m, const Expected& e) {
      const Pose end = clip(m, "twist").sample(clip(m, "twist").duration);
      std::set<int> twisted;
      for (const std::string& name : e.twisted) twisted.insert(joint_named(m, name));
      bool right = true;
      for (int j = 1; j < int(m.joints.size()); ++j)
        right = right && std::abs(turned_against_parent(m, end, j) - (twisted.contains(j) ? 180 : 0)) < 1e-5;
      return Checked(right, long(m.joints.size()));
    });
  });

  t.example("the clips are continuous, signs of quaternions included", {}, [] {
    return for_each_model([](const Model& m, const Expected&) {
      double largest = 0;
      for (const Clip& c : m.clips)
        for (int i = 0; i < 1000; ++i)
          largest = std::max(largest, difference(c.sample(c.duration * i / 1000), c.sample(c.duration * (i + 1) / 1000)));
      return Checked(largest < 0.02, 2000, "largest step in a thousandth: " + std::to_string(largest));
    });
  });

  t.example("the joints turn without sudden changes of speed", {}, [] {
    return for_each_model([](const Model& m, const Expected&) {
      // This is the second difference of a component of a quaternion, at steps of a thousandth.
      double largest = 0;
      for (const Clip& c : m.clips)
        for (int i = 1; i < 1000; ++i) {
          const Pose last = c.sample(c.duration * (i - 1) / 1000), now = c.sample(c.duration * i / 1000),
                     next = c.sample(c.duration * (i + 1) / 1000);
          for (std::size_t j = 0; j < now.size(); ++j) {
            const Quaternion<double> change = last[j].rotation - 2 * now[j].rotation + next[j].rotation;
            largest = std::max(largest, change.cwiseAbs().maxCoeff());
          }
        }
      return Checked(largest < 5e-4, 2000, "largest second difference: " + std::to_string(largest));
    });
  });
}

void the_walk(Suite& t) {
  t.example("the walk is periodic, moves, and keeps half a period between left and right", {}, [] {
    return for_each_model([](const Model& m, const Expected&) {
      const Clip& walk = clip(m, "walk");
      const Pose start = walk.sample(0), quarter = walk.sample(walk.duration / 4);
      const Pose left = walk.sample(0.2 * walk.duration), right = walk.sample(0.7 * walk.duration);
      const double swing = turned_against_parent(m, left, joint_named(m, "left_shin"));
      const double other = turned_against_parent(m, right, joint_named(m, "right_shin"));
      return Checked(difference(start, walk.sample(walk.duration)) < 1e-9 && difference(start, quarter) > 0.05 && swing > 1 &&
                         std::abs(swing - other) < 1e-6,
                     4);
    });
  });

  t.example("while walking, the lowest point of the skin stays on the ground", {}, [] {
    return for_each_model([](const Model& m, const Expected&) {
      double lowest = 1, highest = -1;
      for (const double time : times_of(clip(m, "walk"))) {
        const Pose pose = clip(m, "walk").sample(time);
        double height = 1;
        for (std::size_t v = 0; v < m.vertices.size(); ++v) {
          double y = 0;
          for (const Influence& i : m.influences[v]) y += i.weight * apply(pose[i.joint], m.vertices[v])[1];
          height = std::min(height, y);
        }
        lowest = std::min(lowest, height), highest = std::max(highest, height);
      }
      return Checked(lowest > -0.03 && highest < 0.03, 25,
                     "between " + std::to_string(lowest) + " and " + std::to_string(highest) + " m");
    });
  });
}

}  // namespace

PROPTEST(procedural) {
  numbers_of_triangles_and_joints(t);
  skins_are_closed_surfaces_of_good_triangles(t);
  weights_of_joints(t);
  clips_keep_joints_together_and_turn_smoothly(t);
  the_walk(t);
}

}  // namespace proptests::suite_procedural
