// SPDX-License-Identifier: GPL-3.0-or-later
// Tests every public entry in every floating-point mode that a caller may have set.
#include "algorithms/runtime/packs/float_environment.hpp"

#include <cstring>
#include <filesystem>
#include <functional>
#include <set>

#include "algorithms/bake/bake.hpp"
#include "algorithms/bake/over_time/animated_joints.hpp"
#include "algorithms/bake/over_time/any_pose.hpp"
#include "algorithms/bake/over_time/bound_over_time.hpp"
#include "algorithms/bake/over_time/model_bounds.hpp"
#include "algorithms/bake/over_time/moving_vertices.hpp"
#include "algorithms/bake/over_time/node_motions.hpp"
#include "algorithms/bake/weight_hull.hpp"
#include "algorithms/certificate/documents.hpp"
#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/methods/refit/deformed.hpp"
#include "algorithms/methods/refit/volume_variants.hpp"
#include "algorithms/methods/volumes/box_orientation.hpp"
#include "algorithms/results/result_file.hpp"
#include "algorithms/results/write_whole.hpp"
#include "algorithms/runtime/balls/few_balls_ball.hpp"
#include "algorithms/runtime/batch/batch_refit.hpp"
#include "algorithms/runtime/batch/packed_vertices.hpp"
#include "algorithms/runtime/collide/crowd.hpp"
#include "algorithms/runtime/collide/meeting_boxes.hpp"
#include "algorithms/runtime/mesh/quantize.hpp"
#include "algorithms/runtime/refit/frame_refits.hpp"
#include "algorithms/runtime/skinning/skin.hpp"
#include "algorithms/verification/score.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/procedural/subdivide.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "proptests/gen/accepted.hpp"
#include "proptests/gen/animated_model.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/float_mode.hpp"
#include "proptests/oracles/workers_on_threads.hpp"

namespace proptests::suite_float_environment {
namespace {

using namespace refitlab;

// Holds what an entry answered as bytes, to be compared exactly.
class Bytes {
 public:
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(T x) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &x, sizeof(T));
    text_.append(bytes, sizeof(T));
  }
  template <class T, int D>
  void add(const Eigen::Matrix<T, D, 1>& v) {
    for (int i = 0; i < D; ++i) add(v[i]);
  }
  template <class T, int D>
  void add(const Ball<T, D>& ball) {
    add(ball.center), add(ball.radius);
  }
  void add(const Box<double>& box) { add(box.low), add(box.high); }
  void add(const std::string& text) { text_ += text; }
  void add(const TrianglePair& pair) { add(pair.first), add(pair.second); }
  void add(const RigidTransform<double>& t) { add(t.rotation), add(t.translation); }
  void add(const Motion<double>& m) { add(m.size), add(m.speed), add(m.acceleration); }
  void add(const ChainMotion<double>& c) { add(c.linear), add(c.offset), add(c.rotation); }
  void add(const BoundedPart& part) {
    add(part.box.low), add(part.box.high), add(part.ball);
    for (const Slab<float>& slab : part.slabs) add(slab.low), add(slab.high);
  }
  template <class T>
  void add_all(const T& list) {
    for (const auto& x : list) add(x);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

// Makes a snake some of whose coordinates are denormal, as are differences of others, so that every mode has something to change.
Model snake_with_denormals() {
  Model model = make_snake(4);
  // Only the triangles of its tail stay, so that all modes are tried in seconds.
  model.triangles.resize(96);
  for (std::size_t v = 0; v < model.vertices.size(); v += 3) model.vertices[v][0] = 3e-310 * static_cast<double>(v);
  for (std::size_t v = 1; v < model.vertices.size(); v += 7) model.vertices[v] = Point3(0x1p-1060, 0x1p-1070, 0x1p-1074);
  return model;
}

// Holds what the entries are asked about, made in the default mode.
struct World {
  AnimatedCharacter character = bake_animated(snake_with_denormals(), {.triangles_per_leaf = 4});
  Pose pose = character.clips[0].sample(0.3);
  SkinningPalette<double> palette = make_skinning_palette(character.mesh, character.sets, pose, Skinning::spherical);
  std::vector<Point3> deformed = skin(character.mesh, character.sets, palette, Skinning::spherical);
  std::vector<Ball3<double>> balls = refit_all(character, default_variant(Skinning::spherical), palette);
  ClusterTree clusters{character, {.most_triangles = 32, .most_children = 4}};
  SyntheticCase query = make_synthetic_case(1, 3);
  RigidTransform<double> near{identity_quaternion<double>(), {0.15, 0.02, 1e-311}};
};

void add_palette(Bytes& out, const SkinningPalette<double>& palette) {
  for (std::size_t s = 0; s < palette.size(); ++s) {
    const auto set = palette[s];
    out.add_all(set.transforms), out.add(set.rotation_center), out.add_all(set.center_images), out.add_all(set.duals);
    if (palette.is_measured())
      out.add(palette.scales(s).inverse_blend), out.add(palette.rounding(s, Skinning::linear).weight_vertices.offset);
  }
}

void add_weight_vertices(Bytes& out, const std::vector<std::vector<double>>& weight_vertices) {
  for (const auto& weight_vertex : weight_vertices) out.add_all(weight_vertex);
}

struct Entry {
  std::string name;
  std::function<void(const World&, Bytes&)> ask;
};

std::vector<Entry> building_entries() {
  return {
      {"make_snake, its clip",
       [](const World&, Bytes& out) {
         const Model m = make_snake(3);
         out.add_all(m.vertices), out.add_all(m.clips[0].sample(0.37));
       }},
      {"subdivide", [](const World& w, Bytes& out) { out.add_all(subdivide(Model{w.character.mesh}).vertices); }},
      {"Character, its pieces",
       [](const World& w, Bytes& out) {
         const auto c = bake(w.character.mesh);
         for (const TreeNode& n : c.tree.nodes) out.add(n.reference);
         for (const Pieces kind : {Pieces::node, Pieces::joint_sets, Pieces::mixed, Pieces::many}) {
           const auto node = c.refit_node(0, w.palette, kind);
           for (std::size_t i = 0; i < node.pieces.size(); ++i) out.add(node.piece_reference(i));
         }
       }},
      {"quantize_weights",
       [](const World&, Bytes& out) {
         for (const auto& [joint, weight] : quantize_weights({{0, 0.1}, {3, 1e-310}, {7, 0.7}})) out.add(weight);
       }},
      {"weight_polytope, extreme_rows",
       [](const World&, Bytes& out) {
         const std::vector<double> rows[] = {{0.25, 0.75}, {0x1p-24, 1 - 0x1p-24}, {0.5, 0.5}};
         const std::vector<std::span<const double>> list{rows[0], rows[1], rows[2]};
         add_weight_vertices(out, weight_polytope(list)), add_weight_vertices(out, extreme_rows(list));
       }},
  };
}

std::vector<Entry> refitting_entries() {
  std::vector<Entry> entries;
  for (const Skinning skinning : gen::all_skinnings)
    entries.push_back(
        {"poses and skin, skinning " + std::to_string(static_cast<int>(skinning)), [skinning](const World& w, Bytes& out) {
           const auto& c = w.character;
           const auto palette = make_skinning_palette(c.mesh, c.sets, w.pose, skinning);
           add_palette(out, palette);
           out.add_all(skin(c.mesh, c.sets, palette, skinning));
           for (const Target target : available_targets()) {
             SkinningPalette<double> packed;
             PalettePacks(c.mesh, c.sets, skinning).make(w.pose, packed, target);
             packed.measure();
             add_palette(out, packed);
             std::vector<Point3> skinned(c.mesh.vertices.size());
             PackedVertices(c.mesh, c.sets).skin_all(packed, skinning, skinned, target);
             out.add_all(skinned);
           }
         }});
  for (const RefitVariant& variant : compared_variants())
    entries.push_back({"refit variant " + variant.name, [&variant](const World& w, Bytes& out) {
                         out.add_all(refit_all(w.character, variant, w.palette));
                         for (std::size_t n = 0; n < w.character.tree.nodes.size(); ++n)
                           out.add(
                               variant.refit_as_computed(w.character.refit_node(static_cast<int>(n), w.palette, variant.pieces)));
                       }});
  for (const VolumeVariant& variant : volume_variants())
    entries.push_back({"volume variant " + variant.name, [&variant](const World& w, Bytes& out) {
                         const auto add = [&](const Volume& volume) {
                           std::visit(
                               [&]<class V>(const V& v) {
                                 // Nothing but doubles is in it, so there is no padding.
                                 static_assert(sizeof(V) % sizeof(double) == 0);
                                 out.add(std::string(reinterpret_cast<const char*>(&v), sizeof(v)));
                               },
                               volume);
                         };
                         for (std::size_t n = 0; n < w.character.tree.nodes.size(); ++n)
                           add(variant.refit(w.character.refit_node(static_cast<int>(n), w.palette, variant.pieces)));
                         add(variant.around(w.balls));
                       }});
  entries.push_back({"FrameRefits", [](const World& w, Bytes& out) {
                       FrameRefits refits(w.character, default_variant(Skinning::spherical),
                                          {.most_joint_sets = 2, .children_first = true});
                       refits.begin(w.palette), refits.refit_all();
                       for (std::size_t n = 0; n < w.balls.size(); ++n) out.add(refits[static_cast<int>(n)]);
                     }});
  entries.push_back({"BatchRefit", [](const World& w, Bytes& out) {
                       BatchRefit batch(w.character.tree, w.character.sets);
                       for (const Target target : available_targets()) {
                         const auto& spherical = batch.spherical(w.palette, target);
                         for (std::size_t n = 0; n < w.balls.size(); ++n) out.add(spherical[static_cast<int>(n)]);
                         const auto& linear = batch.linear(w.palette, target);
                         for (std::size_t n = 0; n < w.balls.size(); ++n) out.add(linear[static_cast<int>(n)]);
                       }
                     }});
  entries.push_back({"optimal_balls, refit_bottom_up, smallest_ball_of_balls, box_orientations", [](const World& w, Bytes& out) {
                       out.add_all(optimal_balls(w.character.tree, w.character.vertices, w.deformed));
                       out.add_all(refit_bottom_up(w.character.tree, w.deformed));
                       out.add(smallest_ball_of_balls(w.balls));
                       out.add_all(box_orientations(w.balls));
                     }});
  return entries;
}

std::vector<Entry> crowd_entries() {
  std::vector<Entry> entries;
  for (const bool two : {false, true})
    entries.push_back({two ? "collide_all, on two threads" : "collide_all, on one thread", [two](const World& w, Bytes& out) {
                         ClusterBody a(w.clusters, Skinning::spherical), b(w.clusters, Skinning::spherical),
                             c(w.clusters, Skinning::linear);
                         a.begin(w.pose, {}), b.begin(w.pose, w.near), c.begin(w.pose, w.near);
                         ClusterBody* const bodies[] = {&a, &b, &c};
                         CrowdCounts counts;
                         for (const Contact& contact :
                              collide_all(bodies, Query::full, counts, two ? oracle::workers_on_threads<2>() : one_worker()))
                           out.add(contact.first), out.add(contact.second), out.add_all(contact.pairs);
                       }});
  entries.push_back({"collide_all, from poses", [](const World& w, Bytes& out) {
                       ClusterBody a(w.clusters, Skinning::spherical), b(w.clusters, Skinning::spherical);
                       ClusterBody* const bodies[] = {&a, &b};
                       const Pose poses[] = {w.pose, w.pose};
                       const RigidTransform<double> placements[] = {{}, w.near};
                       for (int times = 0; times < 2; ++times) {
                         CrowdCounts counts;
                         for (const Contact& contact : collide_all(bodies, poses, placements, Query::full, counts))
                           out.add_all(contact.pairs);
                       }
                     }});
  return entries;
}

std::vector<Entry> query_entries() {
  std::vector<Entry> entries;
  for (const Skinning skinning : gen::all_skinnings)
    entries.push_back(
        {"ClusterBody, skinning " + std::to_string(static_cast<int>(skinning)), [skinning](const World& w, Bytes& out) {
           const ClusterTree tree(w.character, {.most_triangles = 32, .most_children = 4});
           ClusterBody a(tree, skinning), b(tree, skinning);
           a.begin(w.pose, {}), b.begin(w.pose, w.near);
           out.add(a.motion_bound());
           for (std::size_t f = 0; f < tree.wide_nodes().size(); ++f)
             out.add(box_of<double>(a.wide_node_box(static_cast<int>(f))));
           for (std::size_t c = 0; c < tree.clusters().size(); ++c) {
             const int cluster = static_cast<int>(c);
             out.add(box_of<double>(a.clusters().cluster(cluster).box));
             out.add(a.clusters().cluster(cluster).xyz[0]);
             for (const double x : a.clusters().padded_vertex(cluster, 0).of) out.add(x);
           }
           for (const Point3& p : b.triangle(5)) out.add(p);
           QueryCounts counts;
           out.add_all(collide(a, b, Query::full, counts));
         }});
  entries.push_back({"Body", [](const World& w, Bytes& out) {
                       Body a(w.character, default_variant(Skinning::spherical));
                       a.begin(w.pose);
                       QueryCounts counts;
                       out.add_all(collide({a, {}}, {a, w.near}, Query::full, counts));
                     }});
  for (Entry& entry : crowd_entries()) entries.push_back(std::move(entry));
  entries.push_back({"meeting_boxes", [](const World&, Bytes& out) {
                       // Two boxes are apart by a denormal. They are apart only if denormals are kept.
                       const std::vector<Box<double>> boxes{
                           {{0, 0, 0}, {0x1p-1060, 1, 1}}, {{0x1p-1050, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {1, 1, 1}}};
                       for (const auto& [a, b] : meeting_boxes(boxes)) out.add(a), out.add(b);
                     }});
  entries.push_back({"triangles_meet, filter_triangles, place", [](const World& w, Bytes& out) {
                       // A vertex of one triangle is off the other's plane by a denormal. They are apart only if denormals are
                       // kept.
                       const double off = 0x1p-1050;
                       const TrianglePoints flat{Point3(0, 0, 0), {1, 0, 0}, {0, 1, 0}},
                           above{Point3(0.2, 0.2, off), {0.3, 0.2, 1}, {0.2, 0.3, 1}};
                       out.add(triangles_meet(flat, above)), out.add(boxed_triangles_meet(flat, above));
                       out.add(static_cast<int>(filter_triangles(flat, above)));
                       for (const Point3& p : place(w.near, above)) out.add(p);
                     }});
  entries.push_back({"certificate", [](const World& w, Bytes& out) {
                       const auto& variant = default_variant(Skinning::spherical);
                       const auto node = w.character.refit_node(1, w.palette, variant.pieces);
                       out.add(
                           certificate(node, Skinning::spherical, w.balls[1], certified_node(w.character, 1, "a snake", "", "")));
                       out.add(model_document(w.character)), out.add(pose_document(w.character, w.palette, Skinning::spherical));
                     }});
  entries.push_back({"make_synthetic_case, score", [](const World& w, Bytes& out) {
                       out.add(as_text(make_synthetic_case(1, 4).reference.radius));
                       SkinnedCase skinned(w.query, Skinning::spherical);
                       out.add(skinned.smallest_radius());
                       out.add(skinned.score({{0.1, 0.2, 0.3}, 0.7}).worst_miss);
                     }});
  entries.push_back(
      {"format_number", [](const World&, Bytes& out) { out.add(format_number(0.1)), out.add(format_number(1e-310)); }});
  return entries;
}

// Makes two clips of nodes, joints and splines, some of whose coordinates are denormal, with triangles that make several
// clusters.
Model animated(double unit) {
  gen::AnimatedPlan plan;
  plan.rigid = plan.cubic = true, plan.nodes = 5, plan.joints = 4, plan.vertices = 5, plan.seed = 12345;
  Model model = gen::animated_model(plan);
  const Animation second = gen::second_animation(plan, model);
  model.clips.push_back({"second", second.duration, {}, second});
  model.triangles = {{0, 1, 2}, {2, 3, 4}, {1, 2, 3}, {0, 2, 4}, {0, 1, 4}};
  for (Point3& v : model.vertices) v[2] *= 1e-310;
  model.vertices[0] = Point3(3e-310, 1e-320, 0.7);
  for (Point3& v : model.vertices) v *= unit;
  for (Clip& clip : model.clips)
    for (NodeTrack& track : clip.animation.tracks) {
      for (auto& key : track.positions.keys) key.value *= unit;
      for (auto& tangent : track.positions.tangents) tangent.into *= unit, tangent.out *= unit;
    }
  for (auto& node : model.skeleton.nodes) {
    node.local.topRightCorner<3, 1>() *= unit;
    if (node.rest) node.rest->translation *= unit;
  }
  for (auto& joint : model.skeleton.joints) joint.offset.topRightCorner<3, 1>() *= unit;
  return model;
}

// Makes a square of triangles whose sides are denormal, so that their place counts only while denormals are kept.
Model square_of_denormals() {
  constexpr int side = 8;
  Model model = animated(1);
  model.vertices.clear(), model.triangles.clear();
  for (int i = 0; i < side * side; ++i) model.vertices.push_back(1e-310 * Point3(i % side, i / side, 0));
  for (int i = 0; i + side < side * side; ++i)
    if (i % side + 1 < side)
      model.triangles.push_back({i, i + 1, i + side}), model.triangles.push_back({i + side + 1, i + side, i + 1});
  model.influences.assign(model.vertices.size(), {{0, 1}});
  return model;
}

// Holds a model whose lengths are denormal in float, with its bounds. All are made in the default mode, once.
struct OverTimeWorld {
  Model model = animated(1), tiny = animated(1e-39), square = square_of_denormals();
  AnimatedJoints joints{model, model.clips[0].animation, false};
  std::vector<ChainMotion<double>> links = joints.motions(0).links;
  std::vector<Box<double>> boxes = {{{-0.1, 0.1, -0.2}, {0.1, 0.3, 1e38}},
                                    {{-1e-40, 1e-40, -2e-40}, {1e-42, 3e-40, -1e-42}},
                                    {{-1e-320, 0, 3e-321}, {1e-320, 1e-310, 1e-45}}};
  ModelBounds bounds = bound_model(tiny, {.cluster_triangles = 4, .crossfades = true});
};
const OverTimeWorld& over_time() {
  static const OverTimeWorld world;
  return world;
}

std::vector<Entry> over_time_entries() {
  return {
      {"rounded_outward of a box",
       [](const World&, Bytes& out) {
         for (const Box<double>& of : over_time().boxes) {
           const Box<float> box = rounded_outward(of);
           out.add(box.low), out.add(box.high);
         }
       }},
      {"around", [](const World&, Bytes& out) { out.add(around(over_time().bounds.clips[0].parts)); }},
      {"bounds_of_all", [](const World&, Bytes& out) { out.add_all(bounds_of_all(over_time().bounds)); }},
      {"parts_of",
       [](const World&, Bytes& out) {
         for (const Model* model : {&over_time().tiny, &over_time().square})
           for (const ModelPart& part : parts_of(*model, 4)) out.add_all(part.vertices), out.add_all(part.triangles);
       }},
      {"link_motions",
       [](const World&, Bytes& out) {
         for (const Model* model : {&over_time().model, &over_time().tiny}) {
           const auto& times = over_time().joints.times();
           out.add_all(link_motions(model->skeleton.nodes, model->clips[0].animation, times[0], times[1]));
         }
       }},
      {"chain_motions, chain_below",
       [](const World&, Bytes& out) {
         const auto& nodes = over_time().model.skeleton.nodes;
         out.add_all(chain_motions(nodes, over_time().links));
         for (int n = 0; n < static_cast<int>(nodes.size()); ++n) out.add(chain_below(nodes, over_time().links, -1, n));
       }},
      {"bound_over_time, bound_any_pose",
       [](const World&, Bytes& out) {
         const Model& model = over_time().model;
         const JointSets sets(model);
         const MovingVertices vertices(model, sets, Skinning::linear, gen::all_of(model.vertices));
         const BoundOverTime bound = bound_over_time(over_time().joints, vertices, {.tolerance = 0.1, .most_halvings = 64});
         for (const Slab<double>& slab : bound.slabs) out.add(slab.low), out.add(slab.high);
         out.add(bound.ball), out.add(bound.errors.per_rounding), out.add(bound.errors.per_weight);
         if (const auto any = bound_any_pose(model, sets, vertices.vertices(), Skinning::linear)) out.add(any->radius);
       }},
  };
}

std::string answer(const Entry& entry, const World& world) {
  Bytes out;
  entry.ask(world, out);
  return out.text();
}

// Checks that each of these entries in each mode answers as in the default mode, and leaves the caller's mode as it was.
Checked are_the_same(const std::vector<Entry>& entries, const std::vector<oracle::FloatMode>& modes) {
  const World world;
  std::string wrong;
  long asked = 0;
  for (const Entry& entry : entries) {
    const std::string expected = answer(entry, world);
    for (const auto& mode : modes) {
      unsigned after = 0;
      std::string found;
      {
        const oracle::ScopedFloatMode scoped(mode);
        found = answer(entry, world);
        after = oracle::current_float_mode();
      }
      ++asked;
      if (found != expected || found.empty()) wrong += entry.name + " differs (" + mode.name + "); ";
      if (after != mode.control) wrong += entry.name + " leaves another mode (" + mode.name + "); ";
    }
  }
  return {wrong.empty(), asked, wrong};
}

Checked are_the_same_in_all_modes(const std::vector<Entry>& entries) {
  return are_the_same(entries, oracle::other_float_modes());
}

// Lists source files of the library, by the ends of their paths, that need no DefaultFloatEnvironment of their own.
const std::vector<std::string> without_environment{
    "_kernel.cpp",
    "_kernel_table.cpp",  // Entries that have it call these.
    "model/gltf_animations.cpp",
    "model/gltf_description.cpp",
    "model/gltf_file.cpp",
    "model/gltf_meshes.cpp",
    "model/gltf_nodes.cpp",
    "model/gltf_numbers.cpp",
    "model/mesh_binding.cpp",
    "model/regular_file.cpp",    // load_model, gltf_scene and model_of_scene call it.
    "tree/check_character.cpp",  // character_of calls it.
    "program/bake_command.cpp",
    "program/collide_command.cpp",
    "program/clip_certificate.cpp",
    "program/command.cpp",
    "program/extras.cpp",
    "program/info_command.cpp",
    "program/main.cpp",
    "program/peak_memory.cpp",  // run_program calls it.
    "program/json_splice.cpp",
    "over_time/moving_joints.cpp",
    "tree/baked_file.cpp",
    "tree/binary.cpp",
    "tree/glb_file.cpp",
    "tree/cluster_bounds.cpp",  // It has no floating-point arithmetic.
    "certificate/sha256.cpp",
    "packs/targets.cpp",
    "mesh/joint_sets.cpp",
    "tree/character.cpp",
    "tree/sphere_tree.cpp",
    "collide/exact_number.cpp",
    "collide/float_palettes.cpp",
    "results/write_whole.cpp",  // It has no floating-point arithmetic.
};

Checked all_sources_have_it_or_are_listed() {
  std::string missing;
  std::set<std::string> used;
  long files = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator("algorithms")) {
    const std::string path = file.path().string();
    if (!path.ends_with(".cpp")) continue;
    ++files;
    const auto listed = std::find_if(without_environment.begin(), without_environment.end(),
                                     [&](const std::string& end) { return path.ends_with(end); });
    if (listed != without_environment.end()) used.insert(*listed);
    else if (read_whole(path).find("DefaultFloatEnvironment") == std::string::npos) missing += path + "; ";
  }
  for (const auto& end : without_environment)
    if (!used.count(end)) missing += "no file is " + end + " any more; ";
  return {missing.empty() && files > 50, files, missing};
}

}  // namespace

PROPTEST(float_environment) {
  t.example("every mode that is tried changes what plain arithmetic finds", {}, [] {
    volatile double one = 1, ten = 10, third = 3, tiny = 0x1p-1050, two = 2, minus = -1;
    bool ok = true;
    long tried = 0;
    for (const auto& mode : oracle::other_float_modes()) {
      // They are volatile so that nothing is computed later, in another mode.
      volatile double quotient, negative, sum, product;
      {
        const oracle::ScopedFloatMode scoped(mode);
        quotient = one / ten;
        negative = minus / third;
        sum = tiny + 1.0;
        product = tiny * two;
      }
      const bool differs = quotient != 1.0 / 10 || negative != -1.0 / 3 || sum != 1.0 || product != 0x1p-1049;
      ok = ok && (differs || mode.name == "exceptions trap"), ++tried;
    }
    return Checked(ok, tried);
  });
  t.example("while a DefaultFloatEnvironment lives the mode is the default one, then the caller's", {}, [] {
    const unsigned by_default = oracle::current_float_mode();
    bool ok = true;
    long tried = 0;
    for (const auto& mode : oracle::other_float_modes()) {
      const oracle::ScopedFloatMode scoped(mode);
      {
        const DefaultFloatEnvironment environment;
        ok = ok && oracle::current_float_mode() == by_default;
        const DefaultFloatEnvironment inner;
        ok = ok && oracle::current_float_mode() == by_default;
      }
      ok = ok && oracle::current_float_mode() == mode.control;
      ++tried;
    }
    return Checked(ok, tried);
  });
  t.example("every source file of the library has the default environment, or is listed as one that needs none", {},
            [] { return all_sources_have_it_or_are_listed(); });
  t.example(
      "balls at one place and a denormal apart are supported by balls that there are, where a header runs in the caller's mode",
      {}, [] {
        bool ok = true;
        long tried = 0;
        for (const auto& mode : oracle::other_float_modes())
          for (int count = 1; count <= 33; ++count)
            for (const double apart : {0.0, 0x1p-1060}) {
              std::vector<Ball3<double>> balls;
              for (int i = 0; i < count; ++i) balls.push_back({{0.5 + apart * i, 1, 1.5}, apart * i});
              const oracle::ScopedFloatMode scoped(mode);
              const SmallestBallOfBalls found = few_balls_ball(balls);
              for (int k = 0; k < found.support_size; ++k) ok = ok && found.support[k] >= 0 && found.support[k] < count;
              ++tried;
            }
        return Checked(ok, tried);
      });
  t.example("what is built once is the same, bit by bit, in every mode of the caller", {},
            [] { return are_the_same_in_all_modes(building_entries()); });
  t.example("the procedural man, which takes long to make, is the same in the mode that differs most", {}, [] {
    const Entry man{"make_man, its clips", [](const World&, Bytes& out) {
                      const Model m = make_man(400);
                      out.add_all(m.vertices);
                      for (const Clip& clip : m.clips) out.add_all(clip.sample(0.37));
                    }};
    const auto modes = oracle::other_float_modes();
    const auto most =
        std::find_if(modes.begin(), modes.end(), [](const auto& m) { return m.name.starts_with("upward, FTZ, DAZ"); });
    return are_the_same({man}, {most == modes.end() ? modes[0] : *most});
  });
  t.example("poses, skins and refits are the same, bit by bit, in every mode of the caller", {},
            [] { return are_the_same_in_all_modes(refitting_entries()); });
  t.example(
      "bounds over time, what they are made of and what is made of them are the same, bit by bit, in every mode of the caller",
      {}, [] { return are_the_same_in_all_modes(over_time_entries()); });
  t.example("queries and certificates are the same, bit by bit, in every mode of the caller", {},
            [] { return are_the_same_in_all_modes(query_entries()); });
}

}  // namespace proptests::suite_float_environment
