// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <tuple>

#include "algorithms/runtime/packs/float_environment.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/procedural/procedural_motion.hpp"
#include "experiments/procedural/procedural_skeleton.hpp"

namespace refitlab {
namespace {

// These are anatomical landmarks, in metres, on the plane of symmetry and on the left side.
const std::array<Point3, 5> spine = {Point3(0, 0.98, -0.40), Point3(0, 1.01, -0.20), Point3(0, 1.03, 0), Point3(0, 1.06, 0.20),
                                     Point3(0, 1.10, 0.44)};
const std::array<Point3, 7> neck = {Point3(0, 1.14, 0.48), Point3(0, 1.24, 0.60), Point3(0, 1.36, 0.69), Point3(0, 1.49, 0.75),
                                    Point3(0, 1.62, 0.81), Point3(0, 1.73, 0.90), Point3(0, 1.79, 1.02)};
const std::array<Point3, 9> tail = {Point3(0, 0.98, -0.52), Point3(0, 0.93, -0.70), Point3(0, 0.86, -0.87),
                                    Point3(0, 0.78, -1.04), Point3(0, 0.71, -1.22), Point3(0, 0.66, -1.40),
                                    Point3(0, 0.64, -1.58), Point3(0, 0.66, -1.75), Point3(0, 0.71, -1.92)};
const Point3 snout(0, 1.69, 1.36), jaw_hinge(0, 1.72, 1.09), jaw_tip(0, 1.585, 1.30);

const Point3 hip(0.16, 0.90, -0.36), knee(0.25, 0.62, -0.17), hock(0.24, 0.31, -0.47), hind_ball(0.24, 0.06, -0.37),
    hind_tip(0.25, 0.03, -0.19);
const Point3 scapula(0.09, 1.14, 0.28), shoulder(0.18, 0.93, 0.38), elbow(0.23, 0.62, 0.24), wrist(0.22, 0.27, 0.37),
    front_ball(0.22, 0.06, 0.41), front_tip(0.23, 0.03, 0.59);

const Point3 wing_root(0.11, 1.22, 0.20), wing_elbow(0.38, 1.50, 0.00), wing_wrist(0.70, 1.74, 0.24), wing_palm(0.84, 1.78, 0.21),
    flank(0.10, 1.06, -0.25);
const std::array<Point3, 3> finger_middle = {Point3(1.14, 1.78, 0.10), Point3(1.04, 1.60, -0.18), Point3(0.80, 1.50, -0.29)},
                            finger_tip = {Point3(1.52, 1.68, -0.10), Point3(1.26, 1.38, -0.60), Point3(0.78, 1.22, -0.78)};

std::vector<Bone> bones_of_creature() {
  std::vector<Bone> bones = {{"pelvis", "", spine[0], spine[1], 0.12},
                             {"spine_1", "pelvis", spine[1], spine[2], 0.12},
                             {"spine_2", "spine_1", spine[2], spine[3], 0.12},
                             {"chest", "spine_2", spine[3], spine[4], 0.14}};
  const auto add_chain = [&bones](const std::string& name, const auto& points, double first, double last) {
    const int n = int(points.size()) - 1;
    for (int i = 0; i < n; ++i)
      bones.push_back({name + std::to_string(i + 1), i == 0 ? bones.back().name : name + std::to_string(i), points[i],
                       points[i + 1], first + (last - first) * i / n});
  };
  add_chain("neck_", neck, 0.08, 0.06);
  bones.push_back({"head", "neck_6", neck.back(), snout, 0.08});
  bones.push_back({"jaw", "head", jaw_hinge, jaw_tip, 0.04});
  add_chain("tail_", tail, 0.08, 0.05);
  for (Bone& bone : bones)
    if (bone.name == "tail_1") bone.parent = "pelvis";
  std::vector<Bone> left_side = {
      {"thigh", "pelvis", hip, knee, 0.09},
      {"shin", "thigh", knee, hock, 0.06},
      {"foot", "shin", hock, hind_ball, 0.05},
      {"toes", "foot", hind_ball, hind_tip, 0.05},
      {"scapula", "chest", scapula, shoulder, 0.08},
      {"upper_arm", "scapula", shoulder, elbow, 0.07},
      {"forearm", "upper_arm", elbow, wrist, 0.05},
      {"hand", "forearm", wrist, front_ball, 0.05},
      {"fingers", "hand", front_ball, front_tip, 0.05},
      {"wing_arm", "chest", wing_root, wing_elbow, 0.09},
      {"wing_forearm", "wing_arm", wing_elbow, wing_wrist, 0.09},
      {"wing_hand", "wing_forearm", wing_wrist, wing_palm, 0.09},
  };
  for (int i = 0; i < 3; ++i) {
    const std::string name = "wing_finger_" + std::to_string(i + 1);
    left_side.push_back({name, "wing_hand", wing_palm, finger_middle[i], 0.10});
    left_side.push_back({name + "_tip", name, finger_middle[i], finger_tip[i], 0.10});
  }
  add_pair(bones, left_side);
  return bones;
}

// The wings come first, because the carving of their trailing edge must not cut into anything else.
void add_wings(ImplicitBody& body) {
  Sides sides{body};
  constexpr double half_thickness = 0.013, blend = 0.015;
  for (int i = 0; i < 2; ++i) {  // between two fingers
    sides.add_membrane(wing_palm, finger_middle[i], finger_middle[i + 1], half_thickness, blend);
    sides.add_membrane(finger_middle[i], finger_tip[i], finger_middle[i + 1], half_thickness, blend);
    sides.add_membrane(finger_tip[i], finger_tip[i + 1], finger_middle[i + 1], half_thickness, blend);
  }
  sides.add_membrane(wing_elbow, wing_wrist, wing_palm, half_thickness, blend);
  sides.add_membrane(wing_palm, finger_middle[2], wing_elbow, half_thickness, blend);
  sides.add_membrane(wing_elbow, finger_middle[2], finger_tip[2], half_thickness, blend);
  sides.add_membrane(wing_elbow, finger_tip[2], flank, half_thickness, blend);
  sides.add_membrane(wing_elbow, flank, wing_root, half_thickness, blend);
  const std::array<Point3, 4> trailing = {finger_tip[0], finger_tip[1], finger_tip[2], flank};
  for (int i = 0; i < 3; ++i) {  // scallops
    const Point3 middle = (trailing[i] + trailing[i + 1]) / 2;
    const Point3 inside = (i < 2 ? wing_palm : wing_elbow) - middle;
    const Point3 edge = (trailing[i + 1] - trailing[i]).normalized();
    const Point3 outward = -(inside - dot(inside, edge) * edge).normalized();
    const double half = norm(Point3(trailing[i] - middle));
    const Point3 center = middle + 1.05 * half * outward;
    sides.carve_cone(center, 1.31 * half, center, 1.31 * half, 0.01);
  }
  sides.add_cone(wing_root, 0.085, wing_elbow, 0.045, 0.05);
  sides.add_cone(wing_elbow, 0.045, wing_wrist, 0.034, 0.03);
  sides.add_cone(wing_wrist, 0.034, wing_palm, 0.032, 0.02);
  sides.add_cone(wing_wrist, 0.028, wing_wrist + Point3(0.02, 0.11, 0.09), 0.010, 0.02);  // claw
  for (int i = 0; i < 3; ++i) {
    sides.add_cone(wing_palm, 0.028, finger_middle[i], 0.022, 0.02);
    sides.add_cone(finger_middle[i], 0.022, finger_tip[i], 0.013, 0.02);
  }
}

void add_trunk(ImplicitBody& body) {
  Sides sides{body};
  body.add_cone({0, 0.955, -0.36}, 0.165, {0, 0.950, 0.02}, 0.190, 0.05);
  body.add_cone({0, 0.950, 0.02}, 0.190, {0, 0.985, 0.30}, 0.225, 0.05);
  body.add_ellipsoid({0, 0.960, 0.38}, {0.150, 0.190, 0.160}, 0.06);     // breast
  sides.add_ellipsoid({0.10, 1.12, 0.20}, {0.085, 0.100, 0.200}, 0.06);  // muscles of the wing
  body.add_cone({0, 1.03, 0.36}, 0.185, neck[0], 0.150, 0.08);
  for (std::size_t i = 0; i + 1 < neck.size(); ++i)
    body.add_cone(neck[i], 0.145 - 0.013 * i, neck[i + 1], 0.132 - 0.013 * i, 0.008);
  body.add_cone({0, 0.965, -0.34}, 0.165, tail[0], 0.135, 0.06);
  for (std::size_t i = 0; i + 1 < tail.size(); ++i)
    body.add_cone(tail[i], 0.132 - 0.0145 * i, tail[i + 1], 0.1175 - 0.0145 * i, 0.008);
  body.add_ellipsoid(tail.back() + Point3(0, 0.02, -0.06), {0.085, 0.020, 0.120}, 0.03);  // blade at its end
  // These are spikes along the back, in the plane of symmetry.
  const auto spike = [&](const Point3& from, const Point3& to, double skin, double height) {
    const Point3 along = (to - from).normalized(), up(0, along[2], -along[1]);
    const Point3 base = (from + to) / 2 + 0.8 * skin * up;
    body.add_cone(base, 0.35 * height, base + (0.2 * skin + height) * up - 0.6 * height * along, 0.012, 0.03);
  };
  for (std::size_t i = 0; i + 1 < neck.size(); ++i) spike(neck[i], neck[i + 1], 0.14 - 0.013 * i, 0.095);
  for (std::size_t i = 0; i + 2 < tail.size(); ++i) spike(tail[i + 1], tail[i], 0.125 - 0.0145 * i, 0.100 - 0.007 * i);
  for (std::size_t i = 0; i + 1 < spine.size(); ++i) spike(spine[i], spine[i + 1], 0.145, 0.105);
}

void add_head(ImplicitBody& body) {
  Sides sides{body};
  body.add_ellipsoid({0, 1.785, 1.06}, {0.088, 0.082, 0.125}, 0.05);
  body.add_cone({0, 1.765, 1.10}, 0.074, {0, 1.700, 1.335}, 0.046, 0.05);  // upper jaw
  body.add_cone({0, 1.690, 1.08}, 0.050, jaw_tip, 0.027, 0.03);
  sides.add_cone({0.030, 1.665, 1.07}, 0.040, {0.012, 1.592, 1.27}, 0.024, 0.02);
  sides.add_cone({0.055, 1.840, 1.06}, 0.022, {0.042, 1.800, 1.19}, 0.016, 0.03);      // brow
  sides.carve_cone({0.090, 1.795, 1.140}, 0.032, {0.094, 1.795, 1.140}, 0.032, 0.01);  // eye socket
  sides.add_ellipsoid({0.056, 1.795, 1.140}, {0.021, 0.019, 0.021}, 0.004);
  sides.add_ellipsoid({0.024, 1.735, 1.340}, {0.020, 0.016, 0.028}, 0.02);          // nostril
  sides.add_cone({0.050, 1.840, 1.02}, 0.034, {0.100, 1.930, 0.900}, 0.024, 0.03);  // horn
  sides.add_cone({0.100, 1.930, 0.900}, 0.024, {0.125, 2.030, 0.830}, 0.011, 0.01);
  sides.add_cone({0.070, 1.740, 1.02}, 0.026, {0.130, 1.730, 0.900}, 0.011, 0.03);  // spike of the cheek
}

// Adds three toes with claws, which start at the ball and end about the tip.
void add_toes(Sides sides, const Point3& ball, const Point3& tip) {
  const Point3 forward = tip - ball, across(norm(forward), 0, 0);
  for (const double splay : {-0.42, 0., 0.42}) {
    const Point3 from = ball + 0.12 * splay * across, reach = (1 - 0.4 * sq(splay)) * forward + splay * across;
    const Point3 joint = from + 0.55 * reach + Point3(0, 0.022, 0);
    sides.add_cone(from, 0.038, joint, 0.028, 0.02);
    sides.add_cone(joint, 0.028, from + 0.90 * reach, 0.024, 0.006);
    sides.add_cone(from + 0.90 * reach, 0.022, from + 1.20 * reach - Point3(0, 0.010, 0), 0.012, 0.006);
  }
}

void add_legs(ImplicitBody& body) {
  Sides sides{body};
  sides.add_cone(hip, 0.135, knee + Point3(-0.01, 0.03, -0.01), 0.075, 0.06);
  sides.add_ellipsoid({0.20, 0.80, -0.34}, {0.085, 0.150, 0.130}, 0.05);  // back of the thigh
  sides.add_cone(knee, 0.074, hock, 0.042, 0.03);
  sides.add_cone(hock, 0.044, hind_ball + Point3(0, 0.01, 0), 0.042, 0.02);
  add_toes(sides, hind_ball, hind_tip);
  sides.add_cone(scapula, 0.110, shoulder, 0.105, 0.06);
  sides.add_cone(shoulder, 0.108, elbow, 0.066, 0.05);
  sides.add_cone(elbow, 0.066, elbow + 0.35 * (wrist - elbow) + Point3(0, 0, 0.01), 0.062, 0.03);
  sides.add_cone(elbow + 0.35 * (wrist - elbow), 0.060, wrist, 0.042, 0.03);
  sides.add_cone(wrist, 0.044, front_ball + Point3(0, 0.01, 0), 0.042, 0.02);
  add_toes(sides, front_ball, front_tip);
  body.carve_cone({0, -50, 0}, 50, {0, -50, 0}, 50, 0.01);  // the ground flattens the soles
}

// Triangles are smaller at the head, the feet and the joints, and larger on the wings.
double edge_size(const Point3& p) {
  const Point3 left(std::abs(p[0]), p[1], p[2]);
  const auto near = [&](const Point3& place, double radius) {
    return std::exp(-squared_distance<double, 3>(left, place) / sq(radius));
  };
  const double head = near({0.03, 1.76, 1.15}, 0.17) + 0.6 * near({0.08, 1.93, 0.92}, 0.12);
  const double feet = near(hind_tip, 0.18) + near(front_tip, 0.18);
  const double joints = near(knee, 0.15) + near(hock, 0.15) + near(elbow, 0.15) + near(wrist, 0.15);
  const double wing = 1 / (1 + std::exp(-(left[0] - 0.34) / 0.04));
  return (1 + 0.2 * wing) / (1 + 1.8 * head + 0.9 * feet + 0.2 * joints);
}

Clip walk_of_creature(const std::vector<Joint>& joints) {
  std::vector<Sole> soles;
  for (std::size_t j = 0; j < joints.size(); ++j)
    for (const auto& [name, ball, tip] : {std::tuple("toes", hind_ball, hind_tip), std::tuple("fingers", front_ball, front_tip)})
      for (Point3 sole : {ball, tip})
        if (joints[j].name.ends_with(std::string("_") + name)) {
          sole[0] = joints[j].origin[0], sole[1] = 0;
          soles.push_back({int(j), sole});
        }
  // These are degrees at tenths of the period, from the moment the foot comes down. It is off the ground in the last third.
  const std::vector<double> hip_forward = {18, 13, 8, 2, -4, -10, -16, -8, 10, 20};
  const std::vector<double> knee_flexion = {0, 3, 4, 4, 3, 3, 10, 30, 30, 10};
  const std::vector<double> shoulder_forward = {15, 11, 6, 1, -5, -10, -15, -10, 6, 16};
  const std::vector<double> elbow_flexion = {2, 0, 0, 0, 0, 0, 6, 34, 42, 18};
  const std::vector<double> wrist_flexion = {0, 0, 0, 0, -4, -10, 10, 52, 46, 14};
  const std::vector<double> toe_droop = {-4, 0, 0, 0, 0, 8, 26, 26, 4, -8};
  constexpr double period = 1.2;
  const auto sample = [=](double time) {
    const DefaultFloatEnvironment environment;
    const Point3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const auto wave = [&](double lag, double frequency = 1) {
      return std::sin(2 * std::numbers::pi * frequency * (time / period - lag));
    };
    Turns turns;
    turns["pelvis"] = multiply(turn(y, 4 * wave(0.75)), turn(z, 2 * wave(0.75)));
    turns["spine_1"] = turn(y, -3 * wave(0.75));
    turns["spine_2"] = turn(y, -3 * wave(0.75));
    turns["chest"] = multiply(turn(y, -2 * wave(0.75)), turn(x, 1.5 * wave(0.1, 2)));
    for (int i = 1; i <= 6; ++i)
      turns["neck_" + std::to_string(i)] = multiply(turn(y, 2.5 * wave(0.9 + 0.05 * i)), turn(x, 2 * wave(0.05 * i, 2)));
    turns["head"] = turn(x, -5 * wave(0.25, 2));
    turns["jaw"] = turn(x, 5 + 5 * wave(0.2));
    for (int i = 1; i <= 8; ++i)
      turns["tail_" + std::to_string(i)] = multiply(turn(y, 8 * wave(0.09 * i)), turn(x, 2 * wave(0.1 * i, 2)));
    for (const double side : {1., -1.}) {
      const std::string name = side > 0 ? "left_" : "right_";
      const double hind = time / period + (side > 0 ? 0 : 0.5), front = hind - 0.25;
      const double thigh = -periodic(hip_forward, hind), shin = periodic(knee_flexion, hind), foot = -0.9 * shin;
      turns[name + "thigh"] = turn(x, thigh);
      turns[name + "shin"] = turn(x, shin);
      turns[name + "foot"] = turn(x, foot);
      turns[name + "toes"] = turn(x, periodic(toe_droop, hind) - thigh - shin - foot);  // flat while on the ground
      const double upper = -periodic(shoulder_forward, front), fore = -periodic(elbow_flexion, front);
      const double hand = periodic(wrist_flexion, front);
      turns[name + "scapula"] = turn(x, 0.3 * upper);
      turns[name + "upper_arm"] = turn(x, 0.7 * upper);
      turns[name + "forearm"] = turn(x, fore);
      turns[name + "hand"] = turn(x, hand);
      turns[name + "fingers"] = turn(x, periodic(toe_droop, front) - upper - fore - hand);
      // The wings are half folded, and beat a little.
      turns[name + "wing_arm"] = multiply(turn(z, side * (14 + 7 * wave(0.1))), turn(y, side * 6));
      turns[name + "wing_forearm"] = turn(z, side * 6 * wave(0.2));
      turns[name + "wing_hand"] = turn(z, side * (-8 + 7 * wave(0.3)));
      for (int i = 1; i <= 3; ++i) {
        const std::string finger = name + "wing_finger_" + std::to_string(i);
        turns[finger] = multiply(turn(z, side * 4 * wave(0.35)), turn(y, side * (14 - 7 * i)));
        turns[finger + "_tip"] = turn(z, side * (-6 + 6 * wave(0.45)));
      }
    }
    return on_the_ground(pose(joints, turns), soles);
  };
  return {"walk", period, sample};
}

Clip twist_of_creature(const std::vector<Joint>& joints) {
  return {"twist", 1, [=](double time) {
            const DefaultFloatEnvironment environment;
            const double angle = 180 * time;
            return pose(joints, {{"neck_3", turn(neck[3] - neck[2], angle)},
                                 {"tail_2", turn(tail[2] - tail[1], angle)},
                                 {"left_upper_arm", turn(elbow - shoulder, angle)},
                                 {"right_wing_arm", turn(mirrored(wing_elbow - wing_root), angle)}});
          }};
}

}  // namespace

Model make_creature() {
  const DefaultFloatEnvironment environment;
  ImplicitBody body;
  add_wings(body);
  add_trunk(body);
  add_head(body);
  add_legs(body);
  const SkinMesh skin = mesh_of(body, 0.014, 13590, edge_size);
  const std::vector<Bone> bones = bones_of_creature();
  const std::vector<Joint> joints = joints_of(bones);
  Model creature{{"creature", skin.vertices, skin.triangles, joints, heat_weights(skin, bones)},
                 {walk_of_creature(joints), twist_of_creature(joints)}};
  validate(creature);
  return creature;
}

}  // namespace refitlab
