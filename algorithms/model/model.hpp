// Model: a skin (triangle mesh), a skeleton, vertex weights, and clips that pose the skeleton (paper 3).
//
// Frames: everything is in model space of the reference posture, right-handed, in the units of the file (its constant
// scale multiplied in). A Posture gives, by joint, the rigid C_j that takes the reference posture to the animated one.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "lemmas/vocabulary/rigid.hpp"

namespace refitlab {

using Point3 = Vec<double, 3>;
using Triangle = std::array<int, 3>;  // indices of vertices, counter-clockwise seen from outside
using Posture = std::vector<RigidTransform<double>>;

// Of a coordinate of a model or a posture: sixth powers, which determinants have, are in the range of double up to here.
inline constexpr double largest_coordinate = 1e40;

struct Joint {
  std::string name;
  int parent;     // index of a joint that comes before this one, or -1
  Point3 origin;  // of its local frame in the reference posture
};

// weight is a multiple of 2^-24, and the weights of a vertex sum to 1 exactly (see algorithms/weights/quantize.hpp).
struct Influence {
  int joint;
  double weight;
};

struct Clip {
  std::string name;
  double duration;                       // seconds
  std::function<Posture(double)> sample;  // at a time in [0, duration]; throws ModelError for a posture that is not rigid
};

struct Model {
  std::string name;
  std::vector<Point3> vertices;
  std::vector<Triangle> triangles;
  std::vector<Joint> joints;
  std::vector<std::vector<Influence>> influences;  // by vertex; distinct joints in increasing order, weights > 0
  std::vector<Clip> clips;
  // How far the skin matrices M of a file, its scale s taken out, are from rotations: the largest Frobenius norm of
  // M^T M / s^2 - I over the joints and the times that were checked on loading. 0 where clips are made of rotations.
  double rigidity_defect = 0;
};

// A model that cannot be used: the message names the file (or generated model), the thing, and the reason.
class ModelError : public std::runtime_error {
 public:
  ModelError(const std::string& file, const std::string& thing, const std::string& reason)
      : std::runtime_error(file + ": " + thing + ": " + reason) {}
};

// Throws ModelError unless the model fits the comments above: indices in range, at least one triangle, coordinates in range,
// weights as stated. Every source of models ends with it.
void validate(const Model& model);

// The posture in which every joint stays where the reference posture has it.
Posture reference_posture(const Model& model);

}  // namespace refitlab
