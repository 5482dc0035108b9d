// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "algorithms/runtime/packs/float_environment.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/procedural/procedural_motion.hpp"
#include "experiments/procedural/procedural_skeleton.hpp"

namespace refitlab {
namespace {

// These are anatomical landmarks of the left side, in metres. The arm is straight and half lowered, and the palm faces the thigh.
const Point3 shoulder(0.185, 1.440, -0.025), arm_direction = Point3(0.76, -0.65, 0.02).normalized();
const Point3 elbow = shoulder + 0.285 * arm_direction, wrist = elbow + 0.255 * arm_direction;
const Point3 knuckles = wrist + 0.095 * arm_direction;
const Point3 forward(0, 0, 1), palm_side = cross(forward, arm_direction);
const Point3 hip(0.090, 0.930, 0), knee(0.100, 0.505, 0.010), ankle(0.108, 0.085, -0.025), ball(0.122, 0.028, 0.100);
const Point3 thumb_base = wrist + 0.028 * arm_direction + 0.026 * forward;
const Point3 thumb_tip = thumb_base + 0.070 * arm_direction + 0.050 * forward;

std::vector<Bone> bones_of_man() {
  std::vector<Bone> bones = {
      {"pelvis", "", {0, 0.960, 0}, {0, 1.060, 0}, 0.08},
      {"waist", "pelvis", {0, 1.070, 0}, {0, 1.165, -0.005}, 0.08},
      {"spine", "waist", {0, 1.175, -0.005}, {0, 1.275, -0.010}, 0.08},
      {"chest", "spine", {0, 1.285, -0.010}, {0, 1.410, -0.015}, 0.08},
      {"neck", "chest", {0, 1.490, -0.025}, {0, 1.595, -0.015}, 0.06},
      {"head", "neck", {0, 1.610, -0.005}, {0, 1.740, 0}, 0.06},
      {"jaw", "head", {0, 1.640, 0.030}, {0, 1.600, 0.080}, 0.04},
  };
  add_pair(bones, {
                      {"clavicle", "chest", {0.030, 1.460, 0}, {0.150, 1.460, -0.020}, 0.06},
                      {"upper_arm", "clavicle", shoulder, elbow, 0.05},
                      {"forearm", "upper_arm", elbow, wrist, 0.04},
                      {"hand", "forearm", wrist, knuckles, 0.03},
                      {"fingers", "hand", knuckles, knuckles + 0.085 * arm_direction, 0.025},
                      {"thumb", "hand", thumb_base, thumb_tip, 0.02},
                      {"thigh", "pelvis", hip, knee, 0.08},
                      {"shin", "thigh", knee, ankle, 0.05},
                      {"foot", "shin", ankle, ball, 0.05},
                      {"toe", "foot", ball, {0.130, 0.020, 0.170}, 0.04},
                  });
  return bones;
}

void add_torso(ImplicitBody& body) {
  Sides sides{body};
  body.add_ellipsoid({0, 1.290, -0.010}, {0.165, 0.190, 0.112}, 0.02);                              // rib cage
  body.add_ellipsoid({0, 1.110, 0.000}, {0.145, 0.170, 0.100}, 0.08);                               // belly
  body.add_ellipsoid({0, 0.965, -0.002}, {0.158, 0.095, 0.105}, 0.08);                              // pelvis
  sides.add_cone({0.050, 1.365, 0.062}, 0.040, {0.115, 1.375, 0.048}, 0.036, 0.05);                 // breast
  sides.add_ellipsoid({0.085, 1.350, -0.078}, {0.080, 0.110, 0.040}, 0.04);                         // shoulder blade
  sides.add_cone({0.110, 1.220, -0.035}, 0.050, {0.150, 1.380, -0.040}, 0.058, 0.05);               // side of the back
  sides.add_cone({0.050, 1.475, -0.035}, 0.050, shoulder + Point3(-0.025, 0.010, 0), 0.050, 0.05);  // collar
  sides.add_cone({0.025, 1.550, -0.040}, 0.036, {0.115, 1.480, -0.035}, 0.036, 0.05);               // neck to shoulder
  sides.add_ellipsoid({0.075, 0.930, -0.062}, {0.076, 0.082, 0.064}, 0.04);                         // buttock
  sides.add_cone({0.045, 1.250, 0.070}, 0.035, {0.042, 1.060, 0.068}, 0.032, 0.04);                 // front of the belly
}

void add_head(ImplicitBody& body) {
  Sides sides{body};
  body.add_cone({0, 1.480, -0.025}, 0.064, {0, 1.640, -0.015}, 0.056, 0.05);           // neck
  body.add_ellipsoid({0, 1.712, -0.005}, {0.074, 0.090, 0.094}, 0.02);                 // skull
  body.add_ellipsoid({0, 1.655, 0.035}, {0.060, 0.065, 0.060}, 0.03);                  // face
  sides.add_cone({0.050, 1.635, 0.015}, 0.016, {0.014, 1.592, 0.078}, 0.016, 0.03);    // jaw
  body.add_cone({-0.008, 1.590, 0.082}, 0.014, {0.008, 1.590, 0.082}, 0.014, 0.02);    // chin
  sides.add_cone({0.040, 1.668, 0.068}, 0.014, {0.052, 1.672, 0.040}, 0.014, 0.02);    // cheek bone
  sides.add_cone({0.010, 1.712, 0.086}, 0.010, {0.044, 1.714, 0.070}, 0.010, 0.02);    // brow
  sides.carve_cone({0.031, 1.692, 0.102}, 0.013, {0.034, 1.692, 0.102}, 0.013, 0.02);  // eye socket
  sides.add_ellipsoid({0.031, 1.692, 0.076}, {0.013, 0.011, 0.012}, 0.005);            // eye
  body.add_cone({0, 1.700, 0.090}, 0.008, {0, 1.662, 0.112}, 0.011, 0.012);            // nose
  sides.add_cone({0.007, 1.657, 0.098}, 0.008, {0.011, 1.657, 0.096}, 0.008, 0.008);   // nostril
  sides.add_cone({0, 1.633, 0.093}, 0.007, {0.018, 1.631, 0.085}, 0.005, 0.008);       // upper lip
  sides.add_cone({0, 1.620, 0.091}, 0.007, {0.015, 1.622, 0.084}, 0.005, 0.006);       // lower lip
  sides.add_ellipsoid({0.077, 1.682, -0.008}, {0.010, 0.031, 0.019}, 0.008);           // ear
}

void add_arms(ImplicitBody& body) {
  Sides sides{body};
  sides.add_cone(shoulder, 0.058, shoulder + 0.13 * arm_direction, 0.040, 0.05);  // shoulder muscle
  sides.add_cone(shoulder + 0.06 * arm_direction, 0.044, elbow, 0.036, 0.03);
  sides.add_cone(shoulder + 0.11 * arm_direction + 0.012 * forward, 0.036, elbow - 0.07 * arm_direction + 0.010 * forward, 0.034,
                 0.03);  // biceps
  sides.add_cone(elbow, 0.037, elbow + 0.07 * arm_direction, 0.041, 0.03);
  sides.add_cone(elbow + 0.07 * arm_direction, 0.041, wrist, 0.025, 0.03);
  // The palm is the four bones behind the fingers; fingers spread a little, so that they are apart all along.
  const Point3 d = arm_direction;
  struct Finger {
    double across, splay, length, radius;
  };
  for (const auto& [across, splay, length, radius] :
       {Finger{0.033, 0.28, 0.074, 0.0090}, Finger{0.011, 0.08, 0.084, 0.0090}, Finger{-0.011, -0.12, 0.078, 0.0085},
        Finger{-0.032, -0.33, 0.060, 0.0080}}) {
    const Point3 knuckle = knuckles + across * forward - 0.15 * std::abs(across) * d;
    const Point3 middle = knuckle + 0.5 * length * (d + splay * forward) + 0.002 * palm_side;
    const Point3 tip = knuckle + length * (d + splay * forward) + 0.008 * palm_side;
    sides.add_cone(wrist + 0.45 * across * forward, 0.016, knuckle, 0.0125, 0.012);
    sides.add_cone(knuckle, radius, middle, radius - 0.0005, 0.003);
    sides.add_cone(middle, radius - 0.0005, tip, radius - 0.002, 0.002);
  }
  sides.add_cone(wrist + 0.015 * d + 0.012 * forward, 0.014, thumb_base + 0.03 * d + 0.018 * forward, 0.014, 0.012);
  sides.add_cone(thumb_base + 0.03 * d + 0.018 * forward, 0.013, thumb_tip, 0.0095, 0.008);
}

void add_legs(ImplicitBody& body) {
  Sides sides{body};
  sides.add_cone(hip + Point3(0.004, -0.02, 0), 0.088, knee + Point3(0, 0.06, 0.004), 0.057, 0.03);
  sides.add_ellipsoid({0.098, 0.730, 0.030}, {0.062, 0.160, 0.060}, 0.04);  // front of the thigh
  sides.add_cone(knee + Point3(0, 0.05, 0.005), 0.054, knee + Point3(0, -0.04, 0), 0.048, 0.03);
  sides.add_cone(knee + Point3(0, -0.04, -0.002), 0.048, ankle + Point3(0, 0.05, 0), 0.032, 0.03);
  sides.add_ellipsoid(knee + Point3(0.002, -0.130, -0.030), {0.050, 0.110, 0.046}, 0.04);  // calf
  sides.add_cone(ankle + Point3(0, 0.07, 0), 0.033, ankle, 0.036, 0.02);
  sides.add_cone(ankle + Point3(0, -0.045, -0.030), 0.034, ankle + Point3(0, -0.02, 0.02), 0.038, 0.03);  // heel
  sides.add_cone(ankle + Point3(0, -0.010, 0.02), 0.038, ball + Point3(-0.014, 0.002, -0.01), 0.027,
                 0.03);  // inner edge
  sides.add_cone(ankle + Point3(0.005, -0.045, 0), 0.034, ball + Point3(0.024, -0.004, -0.03), 0.024,
                 0.03);  // outer edge
  sides.add_cone(ball + Point3(-0.016, -0.003, -0.01), 0.027, ball + Point3(-0.012, -0.011, 0.058), 0.018,
                 0.02);  // big toe
  sides.add_cone(ball + Point3(0.006, -0.005, -0.01), 0.025, ball + Point3(0.014, -0.012, 0.050), 0.015, 0.015);
  sides.add_cone(ball + Point3(0.026, -0.007, -0.02), 0.022, ball + Point3(0.034, -0.013, 0.026), 0.014, 0.015);
  body.carve_cone({0, -50, 0}, 50, {0, -50, 0}, 50, 0.01);  // the ground flattens the soles
}

// Triangles are smaller where there is more to see, and where the skin bends.
double edge_size(const Point3& p) {
  const Point3 left(std::abs(p[0]), p[1], p[2]);
  const auto near = [&](const Point3& place, double radius) {
    return std::exp(-squared_distance<double, 3>(left, place) / sq(radius));
  };
  const double hands = near(knuckles + 0.02 * arm_direction, 0.12), face = near({0, 1.65, 0.10}, 0.09);
  const double head = near({0, 1.68, 0}, 0.14), feet = near(ball, 0.12);
  const double joints = near(elbow, 0.08) + near(knee, 0.10) + near(shoulder, 0.12) + near(hip, 0.15);
  return 1 / (1 + 1.7 * hands + 1.4 * face + 0.5 * head + 0.5 * feet + 0.3 * joints);
}

Clip walk_of_man(const std::vector<Joint>& joints) {
  std::vector<Sole> soles;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const double side = joints[j].name.starts_with("left_") ? 1 : -1;
    if (joints[j].name.ends_with("foot"))
      for (const Point3& p : {Point3(0.108, 0, -0.08), Point3(0.122, 0, 0.09)})
        soles.push_back({int(j), {side * p[0], p[1], p[2]}});
    if (joints[j].name.ends_with("toe")) soles.push_back({int(j), {side * 0.120, 0, 0.165}});
  }
  // These are degrees of flexion at tenths of the period, from the heel strike of the same leg (after Winter's normal gait).
  const std::vector<double> hip_flexion = {24, 21, 13, 4, -5, -11, -6, 10, 22, 26};
  const std::vector<double> knee_flexion = {4, 16, 17, 10, 6, 12, 38, 60, 50, 18};
  const std::vector<double> ankle_flexion = {0, -4, 3, 6, 9, 5, -16, -8, 0, 2};
  const std::vector<double> toe_flexion = {8, 0, 0, 0, 4, 22, 24, 4, 4, 12};
  const auto sample = [=](double time) {
    const DefaultFloatEnvironment environment;
    const Point3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    Turns turns;
    const double swing = std::cos(2 * std::numbers::pi * time);  // 1 when the left heel strikes
    turns["pelvis"] = multiply(turn(y, -7 * swing), turn(x, 2));
    turns["waist"] = turn(y, 5 * swing);
    turns["spine"] = turn(y, 5 * swing);
    turns["chest"] = multiply(turn(y, 4 * swing), turn(x, 2));
    turns["neck"] = turn(y, -4 * swing);
    turns["head"] = multiply(turn(y, -3 * swing), turn(x, -3));
    for (const double side : {1., -1.}) {
      const std::string name = side > 0 ? "left_" : "right_";
      const double phase = side > 0 ? time : time + 0.5;
      turns[name + "thigh"] = multiply(turn(x, -periodic(hip_flexion, phase)), turn(z, -side * 1.5));
      turns[name + "shin"] = turn(x, periodic(knee_flexion, phase));
      turns[name + "foot"] = turn(x, -periodic(ankle_flexion, phase));
      turns[name + "toe"] = turn(x, -periodic(toe_flexion, phase));
      const double arm = -std::cos(2 * std::numbers::pi * (phase - 0.03));  // forward with the other leg
      turns[name + "clavicle"] = multiply(turn(z, -side * 6), turn(y, -side * 3 * arm));
      turns[name + "upper_arm"] = multiply(turn(x, 2 - 22 * arm), turn(z, -side * 34));
      const Point3 elbow_axis = cross(arm_direction, forward).cwiseProduct(Point3(1, side, side));
      turns[name + "forearm"] = turn(elbow_axis, -side * (22 + 14 * arm));
      turns[name + "fingers"] = turn(forward, -side * 25);
    }
    return on_the_ground(pose(joints, turns), soles);
  };
  return {"walk", 1, sample};
}

Clip twist_of_man(const std::vector<Joint>& joints) {
  return {"twist", 1, [=](double time) {
            const DefaultFloatEnvironment environment;
            const double angle = 180 * time;
            const Point3 up(0, 1, 0), right_arm = mirrored(arm_direction);
            return pose(joints, {{"waist", turn(up, angle)},
                                 {"neck", turn(up, -angle)},
                                 {"left_upper_arm", turn(arm_direction, angle)},
                                 {"right_upper_arm", turn(right_arm, angle)}});
          }};
}

}  // namespace

Model make_man() { return make_man(8270); }

Model make_man(int triangles) {
  const DefaultFloatEnvironment environment;
  ImplicitBody body;
  add_torso(body);
  add_head(body);
  add_legs(body);
  add_arms(body);
  const SkinMesh skin = mesh_of(body, 0.007, triangles, edge_size);
  const std::vector<Bone> bones = bones_of_man();
  const std::vector<Joint> joints = joints_of(bones);
  Model man{{"man", skin.vertices, skin.triangles, joints, heat_weights(skin, bones)},
            {walk_of_man(joints), twist_of_man(joints)}};
  validate(man);
  return man;
}

}  // namespace refitlab
