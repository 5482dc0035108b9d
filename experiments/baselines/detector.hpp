// SPDX-License-Identifier: GPL-3.0-or-later
// A Detector finds the touching triangles of two walkers, from poses and placements to pairs.
#pragma once

#include <functional>
#include <memory>

#include "algorithms/runtime/collide/collide.hpp"

namespace refitlab {

// A ScenarioFrame has two copies of a character, each in a pose and at a place.
struct ScenarioFrame {
  Pose first, second;
  RigidTransform<double> first_at, second_at;
};

// DetectorCounts say what was done in all frames since the detector was made. They are 0 and empty where it does not know.
struct DetectorCounts {
  long volume_tests = 0, triangle_tests = 0, vertices_skinned = 0, nodes_refitted = 0;
  std::vector<long> refitted_by_level;  // by level - 1, of detectors that refit the character's sphere tree on demand
};

// A frame consists of its stages in this order. They are separate only so that each can be timed. A detector finds the pairs of
// triangles_meet for the vertices in the world, apply(placement, vertex skinned spherically), in any order.
class Detector {
 public:
  virtual ~Detector() = default;
  virtual void palette(const ScenarioFrame& frame) = 0;  // what skinning prepares
  virtual void skin() {}                                 // all vertices; detectors on demand leave it to the query
  virtual void refit() {}                                // all volumes, likewise
  virtual std::vector<TrianglePair> query(Query query) = 0;
  virtual void forget() {}  // earlier frames; the next frame is the first of a sequence
  virtual DetectorCounts counts() const = 0;

  std::vector<TrianglePair> pairs(const ScenarioFrame& frame, Query kind) {
    palette(frame);
    skin();
    refit();
    return query(kind);
  }
};

// Our own detectors have this in common. Their two bodies count what they did in the current frame, and forget it when the next
// one begins.
class CountingDetector : public Detector {
 public:
  DetectorCounts counts() const override {
    DetectorCounts all = counts_;
    add_frame(all);
    all.volume_tests = tests_.ball_tests;
    all.triangle_tests = tests_.triangle_tests;
    return all;
  }

 protected:
  // Adds what the bodies counted in the current frame.
  virtual void add_frame(DetectorCounts& counts) const = 0;
  // Must be called before a frame begins.
  void keep_frame() { add_frame(counts_); }

  QueryCounts tests_;
  DetectorCounts counts_;  // of the frames before this one
};

// Origin says where a detector comes from.
enum class Origin {
  own,       // ours, on demand
  baseline,  // skins everything; written here
  engine,    // skins everything for a general-purpose engine
  bounded,   // a baseline or an engine that is asked only where the characters' bounds meet
  floor,     // no detector: it is told beforehand where to look
  oracle     // tries all pairs; no detector, but a row of results
};

const char* name_of(Origin origin);  // as in result files

struct DetectorKind {
  std::string name, description;
  Origin origin;
  std::function<std::unique_ptr<Detector>(const Character&)> make;  // the character outlives the detector
  bool is_minor = false;                                            // left out of short runs
  // This share of a scenario's pairs may differ from the right ones, because the volumes of some engines do not account for
  // rounding. Differing pairs are counted.
  double tolerated_share = 0;
};

}  // namespace refitlab
