// SPDX-License-Identifier: GPL-3.0-or-later
// A Separation says why no triangles of two bodies meet except those with a given common point.
//
// The triangles of both bodies are a pair of sets. Planes part such pairs; where none is found, one of the sets is halved.
// In the end there are pairs of triangles, which have a plane between them or a point in common.
#pragma once

#include <variant>
#include <vector>

#include "algorithms/certificate/common_point.hpp"
#include "algorithms/certificate/posed_body.hpp"
#include "algorithms/runtime/collide/collide.hpp"

namespace refitlab {

// Halved says which set of a pair is halved. A set of n triangles has its first n / 2 in the order, rounded down, in its first
// half.
enum class Halved { first, second };
struct Touching {};
using SeparationStep = std::variant<PartingPlane, Halved, Touching>;

struct Separation {
  std::vector<int> first_order, second_order;  // all triangles of the bodies, each once
  // Each step is about the pair of sets that is on top of a stack, and takes it away. Halving puts the pair of the second
  // half there, and then that of the first. It begins with all triangles of both and ends with none. Touching is for pairs of
  // single triangles.
  std::vector<SeparationStep> steps;
  struct Contact {
    TrianglePair pair;
    CommonPoint point;
  };
  std::vector<Contact> contacts;  // a step of Touching each, in their order
};

// All numbers are taken exactly. Throws std::invalid_argument for a coordinate that is not finite, for an index of no vertex,
// and for a body without triangles.
Separation separate(const PosedBody& first, const PosedBody& second);

}  // namespace refitlab
