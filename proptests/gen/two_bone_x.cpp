// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/two_bone_x.hpp"

#include <fstream>
#include <stdexcept>

namespace proptests::gen {
namespace {

// Returns rows of a matrix that acts on row vectors: a shift along y. (To assimp a comma before a digit is a decimal point.)
std::string shift(const std::string& y) { return "1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, " + y + ", 0, 1;;"; }

std::string frame(const std::string& name, const std::string& y, const std::string& inside) {
  return "Frame " + name + " {\n FrameTransformMatrix {\n" + shift(y) + "\n}\n" + inside + "}\n";
}

std::string skin_weights(const std::string& bone, const std::string& vertices, const std::string& weights, const std::string& y) {
  return "SkinWeights {\n\"" + bone + "\";\n6;\n" + vertices + ";\n" + weights + ";\n" + shift(y) + "\n}\n";
}

}  // namespace

void write_x(const TwoBoneX& parts, const std::string& path) {
  std::ofstream out(path);
  out << "xof 0303txt 0032\n";
  if (!parts.ticks_per_second.empty()) out << "AnimTicksPerSecond {\n" << parts.ticks_per_second << ";\n}\n";
  out << frame("root", "0", frame("tip", "1", ""))
      << frame("skin", "0",
               "Mesh {\n6;\n0;0;0;,\n1;0;0;,\n0;1;0;,\n1;1;0;,\n0;2;0;,\n1;2;0;;\n"
               "4;\n3;0, 1, 2;,\n3;1, 3, 2;,\n3;2, 3, 4;,\n3;3, 5, 4;;\n"
               "XSkinMeshHeader {\n2;\n2;\n2;\n}\n" +
                   skin_weights("root", parts.weighted, parts.root_weights, "0") +
                   skin_weights("tip", parts.weighted, parts.tip_weights, "-1") + "}\n")
      << "AnimationSet wave {\nAnimation {\n{ tip }\nAnimationKey {\n0;\n2;\n0;4;1, 0, 0, 0;;,\n"
      << parts.last_key << ";4;0.8, 0, 0, 0.6;;;\n}\n}\n}\n";
  if (!out.flush()) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace proptests::gen
