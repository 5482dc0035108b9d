// SPDX-License-Identifier: MIT
// Clusters of a model's triangles have bounds that hold at every time of a clip, and while one clip fades to another. The nodes
// of the character's tree may have such bounds too. The runtime reads them as bytes.
//
// Format, version 3, as in character_file.hpp: numbers are little-endian, a list is a count (8 bytes) and its members.
//   "rfltimes"                 8 bytes
//   version, size, checksum    4 + 8 + 8 bytes
//   k                          4 bytes: 6, 14, 18 or 26; a bound is a k-DOP, of which the box is the part along the axes
//   primitives                 a list of node, mesh, primitive, skin: 4 bytes each; glTF's indices, or -1
//   clusters                   a list of the primitive's position in that list (4 bytes), and a list of its triangles (4 bytes)
//   clips                      a list of a name (a list of bytes), the duration in seconds (8 bytes), and for each cluster
//                              the box (six floats of 4 bytes: least x, y, z, greatest x, y, z), the ball (x, y, z, radius) and
//                              k/2 - 3 slabs (least and greatest (n, x), for each direction n of slab_directions but the
//                              axes); the same list for each node of the character's tree, or an empty one;
//                              the last clip, whose duration is 0, is the rest pose
//   crossfades                 a list of two positions of clips (4 bytes each) and, for each cluster, bounds as above
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "algorithms/runtime/balls/box.hpp"
#include "algorithms/runtime/balls/slab_directions.hpp"
#include "lemmas/vocabulary/slab.hpp"
#include "lemmas/vocabulary/sphere.hpp"

namespace refitlab {

// The box, the ball and the slabs each enclose the part. They are in the scene's frame, in units of the file. Slabs are scaled by
// the length of their direction.
struct BoundedPart {
  Box<float> box;
  Ball3<float> ball;
  std::vector<Slab<float>> slabs = {};  // by direction of slab_directions(k), without the axes
};

// Returns whether all numbers are finite, no side is reversed, and no radius negative.
bool is_sound(const BoundedPart& part);

struct ClusterBounds {
  struct Primitive {
    int node, mesh, primitive, skin;  // indices of glTF; -1 for none
  };
  struct Cluster {
    int primitive;               // position in primitives
    std::vector<int> triangles;  // of the primitive, in its own order
  };
  struct Clip {
    std::string name;
    double duration;
    std::vector<BoundedPart> clusters;    // by cluster
    std::vector<BoundedPart> nodes = {};  // by node of the character's tree; empty where it was not asked for
  };
  struct Crossfade {
    int first, second;                  // positions of clips
    std::vector<BoundedPart> clusters;  // by cluster
  };
  int dop = 6;  // k
  std::vector<Primitive> primitives;
  std::vector<Cluster> clusters;
  std::vector<Clip> clips;  // the last one is the rest pose
  std::vector<Crossfade> crossfades = {};
};

// Returns the bounds in this format.
std::string bytes_of(const ClusterBounds& bounds);

// file is for error messages. Throws ModelError for bytes that are no such list, end early, have another checksum, or have
// indices out of range, an unknown k, a box whose sides are reversed or a number that is not finite.
ClusterBounds cluster_bounds_of(std::string_view bytes, const std::string& file);

}  // namespace refitlab
