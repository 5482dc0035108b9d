// SPDX-License-Identifier: GPL-3.0-or-later
// Tests glTF files: where the vertices of one with all features are, by its own formulas, and what is refused, by changes of the
// description of one that is read.
#include "algorithms/model/gltf_scene.hpp"

#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <tuple>

#include "algorithms/model/model_of_scene.hpp"
#include "proptests/gen/rich_gltf.hpp"
#include "proptests/gen/rigged_gltf.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/temporary_folder.hpp"

namespace proptests::suite_gltf_scene {
namespace {

using namespace refitlab;
using nlohmann::json;

std::string refusal(const std::string& bytes) {
  try {
    model_of_scene(gltf_scene(bytes, "file.gltf"));
  } catch (const ModelError& e) {
    return e.what();
  }
  return "";
}

json& primitive(json& g) { return g["meshes"][0]["primitives"][0]; }
json& sampler(json& g, int index) { return g["animations"][0]["samplers"][index]; }
json& channel(json& g, int index) { return g["animations"][0]["channels"][index]; }
json& attribute_accessor(json& g, const char* name) { return g["accessors"][std::size_t(primitive(g)["attributes"][name])]; }
json& attribute_view(json& g, const char* name) {
  return g["bufferViews"][std::size_t(attribute_accessor(g, name)["bufferView"])];
}

// Adds a second buffer with these numbers, and returns the index of a view of all of them.
template <class T>
std::size_t add_bytes(json& g, const std::vector<T>& numbers) {
  const std::string bytes(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T));
  g["buffers"].push_back({{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + gen::base64(bytes)}});
  g["bufferViews"].push_back({{"buffer", g["buffers"].size() - 1}, {"byteLength", bytes.size()}});
  return g["bufferViews"].size() - 1;
}

void make_sparse(json& g, const std::vector<std::uint16_t>& indices, std::size_t values) {
  const std::size_t index_view = add_bytes(g, indices), value_view = add_bytes(g, std::vector<float>(3 * values, 1.0f));
  attribute_accessor(g, "POSITION")["sparse"] = {{"count", indices.size()},
                                                 {"indices", {{"bufferView", index_view}, {"componentType", 5123}}},
                                                 {"values", {{"bufferView", value_view}}}};
}

// Puts a cubic spline in place of what a sampler has, each of whose two keys has these in-tangent, value and out-tangent. The
// sampler 1 has the rotations of the joint 1, and the sampler 3 the translations of the joint 0.
void make_spline(json& g, const std::vector<float>& rows, int index = 1, const char* type = "VEC4") {
  std::vector<float> numbers = rows;
  numbers.insert(numbers.end(), rows.begin(), rows.end());
  const std::size_t view = add_bytes(g, numbers), width = type == std::string("VEC4") ? 4 : type == std::string("VEC3") ? 3 : 1;
  g["accessors"].push_back({{"bufferView", view}, {"componentType", 5126}, {"count", numbers.size() / width}, {"type", type}});
  sampler(g, index)["output"] = g["accessors"].size() - 1;
  sampler(g, index)["interpolation"] = "CUBICSPLINE";
}

// Adds a morph target of the mesh that moves the vertex 2 by this in x.
void add_target(json& g, float x, std::size_t vertices = 28) {
  std::vector<float> numbers(3 * vertices, 0.0f);
  numbers[6] = x;
  const std::size_t view = add_bytes(g, numbers);
  g["accessors"].push_back({{"bufferView", view}, {"componentType", 5126}, {"count", vertices}, {"type", "VEC3"}});
  primitive(g)["targets"].push_back({{"POSITION", g["accessors"].size() - 1}});
}

// Moves the weight of the one morph target of the node "skin" between these values at 0 and 1 s.
void move_weight(json& g, float from, float to) {
  const std::size_t view = add_bytes(g, std::vector<float>{0, 1, from, to});
  for (const int offset : {0, 8})
    g["accessors"].push_back(
        {{"bufferView", view}, {"byteOffset", offset}, {"componentType", 5126}, {"count", 2}, {"type", "SCALAR"}});
  json& animation = g["animations"][0];
  animation["channels"].push_back({{"sampler", animation["samplers"].size()}, {"target", {{"node", 3}, {"path", "weights"}}}});
  animation["samplers"].push_back({{"input", g["accessors"].size() - 2}, {"output", g["accessors"].size() - 1}});
}

// Moves the same weight along a spline whose two keys both have this value and these two tangents. The weight's sampler is 4.
void move_weight_along_spline(json& g, float into, float value, float out) {
  move_weight(g, value, value), make_spline(g, {into, value, out}, 4, "SCALAR");
}

// Puts other numbers in place of an attribute of the mesh, four for each of so many vertices. All of them are zeros, joints and
// weights alike.
template <class T>
void replace_attribute(json& g, const char* name, std::size_t vertices) {
  const int component = attribute_accessor(g, name)["componentType"];
  const std::size_t view = add_bytes(g, std::vector<T>(4 * vertices));
  g["accessors"].push_back({{"bufferView", view}, {"componentType", component}, {"count", vertices}, {"type", "VEC4"}});
  primitive(g)["attributes"][name] = g["accessors"].size() - 1;
}

// Replaces the last of the mesh's indices with this one.
void set_last_index(json& g, std::uint32_t index) {
  std::vector<std::uint32_t> indices(144);
  indices.back() = index;
  const std::size_t view = add_bytes(g, indices);
  g["accessors"].push_back({{"bufferView", view}, {"componentType", 5125}, {"count", 144}, {"type", "SCALAR"}});
  primitive(g)["indices"] = g["accessors"].size() - 1;
}

// Adds three more nodes, of which the last is below the one before. They show the mesh without a skin and with another one.
void add_nodes_of_no_scene(json& g) {
  g["skins"].push_back({{"joints", {2, 1, 0}}});
  g["nodes"].push_back({{"mesh", 0}, {"translation", {1, 2, 3}}});
  g["nodes"].push_back({{"mesh", 0}, {"skin", 1}, {"children", {6}}});
  g["nodes"].push_back({{"mesh", 0}, {"skin", 0}});
}

struct Change {
  std::function<void(json&)> change;
  std::string reason;
};

// Lists changes of the description of bending_tube(3): nodes j0 to j2 and "skin", one mesh, one skin, one clip "bend".
std::vector<Change> refused_descriptions() {
  return {
      {[](json& g) { g["asset"].erase("version"); }, "file: says no version of glTF"},
      {[](json& g) { g = json::array(); }, "file: says no version of glTF"},
      {[](json& g) { g["asset"]["version"] = "2.1", g["asset"]["minVersion"] = "2.1"; },
       "file: needs glTF of version 2.1, and 2.0 is what is read"},
      {[](json& g) { g["asset"]["minVersion"] = 2; }, "file: 'minVersion' is not a version of glTF"},
      {[](json& g) { g["extensionsRequired"] = {7}; }, "file: 'extensionsRequired' is not a list of names"},
      {[](json& g) {
         g["extensionsRequired"] = {"KHR_texture_transform", "KHR_draco_mesh_compression"};
       },
       "file: needs the extension KHR_draco_mesh_compression, which is not read"},
      {[](json& g) { g["extensionsRequired"] = {"EXT_meshopt_compression"}; },
       "file: needs the extension EXT_meshopt_compression, which is not read"},
      {[](json& g) {
         primitive(g)["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
       },
       "mesh 0, primitive 0: is compressed by KHR_draco_mesh_compression, which is not read"},
      {[](json& g) {
         channel(g, 1)["target"]["extensions"]["KHR_animation_pointer"] = {{"pointer", "/nodes/0/scale"}};
       },
       "clip 0, channel 1: moves what KHR_animation_pointer says, which is not read"},
      {[](json& g) {
         g["nodes"][3]["extensions"]["EXT_mesh_gpu_instancing"] = {{"attributes", json::object()}};
       },
       "node 3: is shown in the places of EXT_mesh_gpu_instancing, which is not read"},
      {[](json& g) { channel(g, 1).erase("target"); }, "clip 0, channel 1: has no target"},
      {[](json& g) {
         g["buffers"].push_back({{"byteLength", 4}});
       },
       "buffer 1: has no bytes"},
      {[](json& g) {
         g["buffers"].push_back({{"byteLength", 4}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
       },
       "buffer 1: has its bytes compressed by EXT_meshopt_compression, which is not read"},
      {[](json& g) {
         json& attributes = primitive(g)["attributes"];
         attributes["JOINTS_2"] = attributes["JOINTS_0"], attributes["WEIGHTS_2"] = attributes["WEIGHTS_0"];
       },
       "mesh 0: JOINTS_2, but no set 1 of joints and weights"},
      {[](json& g) { primitive(g)["attributes"]["JOINTS_2"] = primitive(g)["attributes"]["JOINTS_0"]; },
       "mesh 0: JOINTS_2, but no set 1 of joints and weights"},
      {[](json& g) { primitive(g)["attributes"]["WEIGHTS_2"] = primitive(g)["attributes"]["WEIGHTS_0"]; },
       "mesh 0: WEIGHTS_2, but no set 1 of joints and weights"},
      {[](json& g) { primitive(g)["attributes"]["WEIGHTS_10"] = primitive(g)["attributes"]["WEIGHTS_0"]; },
       "mesh 0: WEIGHTS_10, but no set 1 of joints and weights"},
      {[](json& g) { g["buffers"][0]["byteLength"] = 0; }, "buffer 0: has no bytes"},
      {[](json& g) {
         g["accessors"][0]["sparse"] = {{"count", 1}, {"indices", json::object()}};
       },
       "accessor 0: is sparse without values"},
      {[](json& g) { g["nodes"][1] = 3; }, "node 1: is not an object of the description"},
      {[](json& g) { g["nodes"] = 3; }, "file: 'nodes' is not a list"},
      {[](json& g) { g["nodes"][1]["name"] = 3; }, "node 1: 'name' is not a text"},
      {[](json& g) { g["accessors"][2]["normalized"] = 1; }, "accessor 2: 'normalized' is not true or false"},
      {[](json& g) { g["nodes"][1]["scale"] = 1; }, "node 1: 'scale' is not a list of numbers"},
      {[](json& g) {
         g["nodes"][1]["scale"] = {1, "1", 1};
       },
       "node 1: 'scale' is not a list of numbers"},
      {[](json& g) { g["nodes"][1]["children"] = 2; }, "node 1: 'children' is not a list of indices"},
      {[](json& g) { primitive(g)["attributes"] = 1; }, "mesh 0, primitive 0: 'attributes' is not an object"},
      {[](json& g) { g["nodes"][3]["mesh"] = "0"; }, "node 3: 'mesh' is not an integer from 0 to 2147483647"},
      {[](json& g) { g["nodes"][3]["mesh"] = 4294967296; }, "node 3: 'mesh' is not an integer from 0 to 2147483647"},
      {[](json& g) { g["nodes"][3]["mesh"] = -1; }, "node 3: 'mesh' is not an integer from 0 to 2147483647"},
      {[](json& g) { g["nodes"][3]["mesh"] = 0.5; }, "node 3: 'mesh' is not an integer from 0 to 2147483647"},
      {[](json& g) {
         g["nodes"][0]["children"] = {1, 2.5};
       },
       "node 0: 'children' is not an integer from 0 to 2147483647"},
      {[](json& g) { g["accessors"][0].erase("type"); }, "glTF description: tinygltf cannot read it: "},
      {[](json& g) { g["buffers"][0]["uri"] = "data:text/html;base64,AAAA"; }, "glTF description: tinygltf cannot read it: "},
      {[](json& g) { primitive(g)["indices"] = 99; }, "glTF description: tinygltf cannot read it: "},
  };
}
std::vector<Change> refused_accessors() {
  return {
      {[](json& g) { primitive(g)["attributes"]["POSITION"] = 99; }, "mesh 0, accessor 99: there is none"},
      {[](json& g) { attribute_accessor(g, "POSITION")["componentType"] = 5130; },
       "mesh 0, accessor 0: glTF has no component type 5130"},
      {[](json& g) { attribute_accessor(g, "POSITION")["type"] = "VEC4"; },
       "mesh 0, accessor 0: is of another type than it has to be here"},
      {[](json& g) { attribute_accessor(g, "POSITION")["componentType"] = 5123; }, "mesh 0, accessor 0: is not of floats"},
      {[](json& g) { attribute_accessor(g, "JOINTS_0")["componentType"] = 5122; },
       "mesh 0, accessor 1: is not of unsigned integers"},
      {[](json& g) { attribute_accessor(g, "JOINTS_0")["normalized"] = true; },
       "mesh 0, accessor 1: is not of unsigned integers"},
      {[](json& g) { attribute_accessor(g, "WEIGHTS_0")["componentType"] = 5123; },
       "mesh 0, accessor 2: is not of floats or normalised integers"},
      {[](json& g) {
         attribute_accessor(g, "POSITION").erase("bufferView"), attribute_accessor(g, "POSITION")["count"] = 2000000000;
       },
       "mesh 0, accessor 0: has more elements than there are bytes in the file"},
      {[](json& g) { attribute_accessor(g, "POSITION")["bufferView"] = 99; },
       "mesh 0, accessor 0: is in a buffer view that there is not"},
      {[](json& g) { attribute_view(g, "POSITION")["buffer"] = 1; }, "mesh 0, accessor 0: is in a buffer that there is not"},
      {[](json& g) { attribute_view(g, "POSITION")["byteLength"] = 999999; },
       "mesh 0, accessor 0: is in a buffer view that reaches past the end of its buffer"},
      {[](json& g) { attribute_view(g, "POSITION")["byteOffset"] = 999999; },
       "mesh 0, accessor 0: is in a buffer view that reaches past the end of its buffer"},
      {[](json& g) { attribute_accessor(g, "POSITION")["byteOffset"] = 4; },
       "mesh 0, accessor 0: reaches past the end of its buffer view"},
      {[](json& g) { attribute_accessor(g, "POSITION")["byteOffset"] = 99999; },
       "mesh 0, accessor 0: reaches past the end of its buffer view"},
      {[](json& g) { attribute_accessor(g, "POSITION")["count"] = 1 + int(attribute_accessor(g, "POSITION")["count"]); },
       "mesh 0, accessor 0: reaches past the end of its buffer view"},
      {[](json& g) { attribute_view(g, "POSITION")["byteStride"] = 16; },
       "mesh 0, accessor 0: reaches past the end of its buffer view"},
      {[](json& g) { make_sparse(g, {0}, 1), attribute_accessor(g, "POSITION")["sparse"]["indices"]["componentType"] = 5126; },
       "mesh 0, accessor 0: has sparse indices that are not unsigned integers"},
      {[](json& g) {
         make_sparse(g, {0, 28}, 2);
       },
       "mesh 0, accessor 0: has sparse indices that are out of range or order"},
      {[](json& g) {
         make_sparse(g, {3, 3}, 2);
       },
       "mesh 0, accessor 0: has sparse indices that are out of range or order"},
      {[](json& g) {
         make_sparse(g, {0, 3}, 1);
       },
       "mesh 0, accessor 0: reaches past the end of its buffer view"},
  };
}
std::vector<Change> refused_nodes() {
  return {
      {[](json& g) {
         g["nodes"][1]["translation"] = {1, 2};
       },
       "node 1 'j1': a translation or scale does not have 3 numbers"},
      {[](json& g) {
         g["nodes"][1]["rotation"] = {1, 2};
       },
       "node 1 'j1': its rotation does not have 4 numbers"},
      {[](json& g) {
         g["nodes"][1]["rotation"] = {0, 0, 0, 0};
       },
       "node 1 'j1': its rotation is by a zero quaternion"},
      {[](json& g) {
         g["nodes"][1]["rotation"] = {0, 0, 1e200, 0};
       },
       "node 1 'j1': its rotation is by a quaternion without a length"},
      {[](json& g) {
         g["nodes"][1]["matrix"] = {1, 2};
       },
       "node 1 'j1': its matrix does not have 16 numbers"},
      {[](json& g) { g["nodes"][1]["matrix"] = std::vector<int>(16, 1); }, "node 1 'j1': its matrix is no affine map"},
      {[](json& g) { g["nodes"][1]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1}; },
       "clip 'bend', joint 'j1': is moved by a clip, but has a matrix"},
      {[](json& g) { g["nodes"][1]["children"].push_back(99); }, "node 1 'j1': has a child that there is not"},
      {[](json& g) { g["nodes"][0]["children"].push_back(2); }, "node 2 'j2': is the child of two nodes, or twice of one"},
      {[](json& g) { g["nodes"][0]["children"].push_back(1); }, "node 1 'j1': is the child of two nodes, or twice of one"},
      {[](json& g) { g["scenes"][0]["nodes"] = {3}, g["nodes"][2]["children"] = {0}; }, "node 0 'j0': is below itself"},
      {[](json& g) { g["scenes"][0]["nodes"].push_back(0); }, "node 0 'j0': is in the scene twice"},
      {[](json& g) { g["scenes"][0]["nodes"].push_back(1); }, "scene 0: names node 1, which is below another or not there"},
      {[](json& g) { g["scenes"][0]["nodes"].push_back(4); }, "scene 0: names node 4, which is below another or not there"},
      {[](json& g) { g["scene"] = 1; }, "file: its default scene is one that there is not"},
      {[](json& g) { g.erase("scenes"); }, "file: its default scene is one that there is not"},
  };
}
std::vector<Change> refused_meshes() {
  return {
      {[](json& g) { attribute_accessor(g, "POSITION")["count"] = 0; }, "mesh 0: is empty"},
      {[](json& g) { g["accessors"][std::size_t(primitive(g)["indices"])]["count"] = 143; },
       "mesh 0: its triangles have 143 indices in all"},
      {[](json& g) { primitive(g)["mode"] = 7; }, "mesh 0: is of mode 7, which glTF has not"},
      {[](json& g) { primitive(g)["attributes"].erase("WEIGHTS_0"); }, "mesh 0: joints and weights of set 0 do not go together"},
      {[](json& g) { set_last_index(g, 28); }, "mesh 0: index 143 names a vertex out of range"},
      {[](json& g) { set_last_index(g, 0x7fffffff); }, "mesh 0: index 143 names a vertex out of range"},
      {[](json& g) { set_last_index(g, 0x80000000); }, "mesh 0: index 143 names a vertex out of range"},
      {[](json& g) { set_last_index(g, 0xffffffff); }, "mesh 0: index 143 names a vertex out of range"},
      {[](json& g) { attribute_accessor(g, "JOINTS_0")["count"] = 27; },
       "mesh 0: joints and weights of set 0 do not fit the vertices"},
      {[](json& g) { attribute_accessor(g, "WEIGHTS_0")["count"] = 27; },
       "mesh 0: joints and weights of set 0 do not fit the vertices"},
      {[](json& g) { replace_attribute<std::uint16_t>(g, "JOINTS_0", 29); },
       "mesh 0: joints and weights of set 0 do not fit the vertices"},
      {[](json& g) { replace_attribute<float>(g, "WEIGHTS_0", 29); },
       "mesh 0: joints and weights of set 0 do not fit the vertices"},
      {[](json& g) { primitive(g)["attributes"].erase("WEIGHTS_0"), primitive(g)["attributes"].erase("JOINTS_0"); },
       "mesh 0: is shown with a skin, but has no joints and weights"},
      {[](json& g) { add_target(g, 1, 27); }, "mesh 0, morph target 0: does not fit the vertices"},
      {[](json& g) { add_target(g, 1, 29); }, "mesh 0, morph target 0: does not fit the vertices"},
      {[](json& g) { add_target(g, 1), add_target(g, 1, 56); }, "mesh 0, morph target 1: does not fit the vertices"},
      {[](json& g) { add_target(g, NAN); }, "mesh 0, morph target 0: the displacement of vertex 2 is not finite"},
      {[](json& g) { g["meshes"][0]["primitives"].push_back(primitive(g)), add_target(g, 1); },
       "mesh 0, primitive 1: has another number of morph targets than the mesh's first primitive"},
      {[](json& g) {
         add_target(g, 1), g["meshes"][0]["weights"] = {0, 1};
       },
       "node 3 'skin': has 2 weights for 1 morph targets"},
      {[](json& g) { g["skins"][0]["joints"] = json::array(); }, "skin 0: has no joints"},
      {[](json& g) { g["skins"][0]["joints"][1] = 99; }, "skin 0: has a joint that there is not"},
      {[](json& g) { g["nodes"][3]["mesh"] = 1; }, "node 3 'skin': shows a mesh that there is not"},
      {[](json& g) { g["nodes"][3]["skin"] = 1; }, "node 3 'skin': has a skin that there is not"},
  };
}
// Lists refused changes of a moving weight. The weight of the one target is 0 where no clip moves it.
std::vector<Change> refused_moving_weights() {
  std::vector<Change> out;
  const auto refused = [&](const auto& move) {
    out.push_back({[move](json& g) { add_target(g, 1), move(g); },
                   "clip 'bend', node 'skin': moves the weights of morph targets, which this program does not bound"});
  };
  for (const auto& [from, to] : {std::pair{0.0f, 1.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, -1e-30f}})
    refused([from = from, to = to](json& g) { move_weight(g, from, to); });
  for (const auto& [into, value, out_of] : {std::tuple{0.0f, 1.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}})
    refused([into = into, value = value, out_of = out_of](json& g) { move_weight_along_spline(g, into, value, out_of); });
  return out;
}
// Lists wrong values for each number of the in-tangent and of the out-tangent of rotations, of translations and of a weight.
std::vector<Change> refused_tangents() {
  std::vector<Change> out;
  for (const float wrong : {INFINITY, -INFINITY, NAN})
    for (const std::size_t width : {4u, 3u, 1u})
      for (const std::size_t row : {0u, 2u})
        for (std::size_t column = 0; column < width; ++column) {
          std::vector<float> rows(3 * width);
          if (width == 4) rows[7] = 1;
          rows[row * width + column] = wrong;
          const auto change = [rows, width](json& g) {
            if (width == 1) add_target(g, 1), move_weight(g, 0, 0);
            const int index = width == 4 ? 1 : width == 3 ? 3 : 4;
            make_spline(g, rows, index, width == 4 ? "VEC4" : width == 3 ? "VEC3" : "SCALAR");
          };
          const std::string joint = width == 4 ? "j1" : width == 3 ? "j0" : "skin";
          out.push_back({change, "clip 'bend', joint '" + joint + "', key 0 at 0.000000 s: a tangent is not finite"});
        }
  return out;
}
std::vector<Change> refused_clips() {
  return {
      {[](json& g) { channel(g, 1)["target"]["node"] = 99; }, "clip 'bend': moves a node that there is not"},
      {[](json& g) { channel(g, 1)["target"]["path"] = "colour"; },
       "clip 'bend', joint 'j1': a channel moves 'colour', which glTF has not"},
      {[](json& g) { channel(g, 1)["target"]["node"] = 2; }, "clip 'bend', joint 'j2': two channels move its rotation"},
      {[](json& g) { sampler(g, 1)["interpolation"] = "QUADRATIC"; },
       "clip 'bend', joint 'j1': interpolates by 'QUADRATIC', which glTF has not"},
      {[](json& g) { channel(g, 1)["sampler"] = 99; }, "clip 'bend', joint 'j1': a channel has a sampler that there is not"},
      {[](json& g) {
         make_spline(g, {0, 0, 0, 0, 0, 0, 0, 1.02f, 0, 0, 0, 0});
       },
       "clip 'bend', joint 'j1', key 0 at 0.000000 s: a spline's rotation by a quaternion that is not of unit length"},
  };
}
std::vector<Change> refused_changes() {
  std::vector<Change> all;
  for (const auto& part : {refused_descriptions(), refused_accessors(), refused_nodes(), refused_meshes(),
                           refused_moving_weights(), refused_tangents(), refused_clips()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

// Returns the vertices of the model at a time, each moved by its morph targets and then by the matrices of its joints.
std::vector<Eigen::Vector3d> posed_vertices(const Model& model, const Clip& clip, double time) {
  std::vector<Eigen::Vector3d> places(model.vertices.begin(), model.vertices.end());
  for (const MorphedMesh& mesh : model.morphs) {
    Eigen::VectorXd weights = Eigen::Map<const Eigen::VectorXd>(mesh.weights.data(), Eigen::Index(mesh.weights.size()));
    for (const WeightTrack& track : clip.animation.weight_tracks)
      if (track.node == mesh.node) weights = weights_at(track, time);
    for (std::size_t t = 0; t < mesh.targets.size(); ++t)
      for (const auto& [vertex, by] : mesh.targets[t].displacements) places[vertex] += weights[Eigen::Index(t)] * by;
  }
  const auto matrices = skin_matrices(model.skeleton, clip.animation, time);
  for (std::size_t v = 0; v < places.size(); ++v) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Influence& i : model.influences[v]) sum += i.weight * (matrices[i.joint] * places[v].homogeneous()).head<3>();
    places[v] = sum;
  }
  return places;
}

const SourcePrimitive* source_of(const Model& model, const gen::RichPrimitive& p) {
  for (const SourcePrimitive& source : model.sources)
    if (source.node == p.node && source.mesh == p.mesh && source.primitive == p.primitive && source.skin == p.skin)
      return &source;
  return nullptr;
}

// Exchanges two accessors of a description, wherever they are named.
void exchange_accessors(json& description, std::size_t a, std::size_t b) {
  std::swap(description["accessors"][a], description["accessors"][b]);
  const auto renamed = [&](json& name) {
    if (name == a) name = b;
    else if (name == b) name = a;
  };
  for (json& mesh : description["meshes"])
    for (json& primitive : mesh["primitives"]) {
      if (primitive.contains("indices")) renamed(primitive["indices"]);
      for (json& attribute : primitive["attributes"]) renamed(attribute);
      if (primitive.contains("targets"))
        for (json& target : primitive["targets"])
          for (json& attribute : target) renamed(attribute);
    }
  for (json& skin : description["skins"]) renamed(skin["inverseBindMatrices"]);
  for (json& animation : description["animations"])
    for (json& sampler : animation["samplers"]) renamed(sampler["input"]), renamed(sampler["output"]);
}

// Returns what is wrong about the model of a rich file, or nothing if it has each primitive where it has to be at all times.
std::string complaint(const gen::RichGltf& rich, const Model& model) {
  if (model.sources.size() != rich.primitives().size()) return "there are " + std::to_string(model.sources.size()) + " sources; ";
  std::string out;
  for (const gen::RichPrimitive& p : rich.primitives()) {
    const std::string label = "node " + std::to_string(p.node) + ", primitive " + std::to_string(p.primitive);
    const SourcePrimitive* source = source_of(model, p);
    if (!source || source->vertices.size() != p.positions.size() || source->triangles.size() != p.triangles.size())
      return label + " has no source that fits; ";
    for (std::size_t t = 0; t < p.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k)
        if (model.triangles[source->triangles[t]][k] != source->vertices[p.triangles[t][k]])
          out += label + ": a corner differs; ";
    for (const double time : {0.0, 0.25, 0.5, 0.9, 1.0, 1.4, 1.5, 2.0}) {
      const auto expected = rich.posed(p, time), places = posed_vertices(model, model.clips[0], time);
      double worst = 0;
      for (std::size_t v = 0; v < expected.size(); ++v)
        worst = std::max(worst, (places[source->vertices[v]] - expected[v]).norm());
      if (!(worst < 2e-6)) out += label + " at " + std::to_string(time) + " s is off by " + std::to_string(worst) + "; ";
    }
  }
  return out;
}

// Lists changes of the same file that are right in glTF, if not in every reader of it. All but the second mesh leave its 48
// triangles.
std::vector<std::pair<const char*, std::function<void(json&)>>> accepted_changes() {
  return {
      {"inverse bind matrices that are not there", [](json& g) { g["skins"][0].erase("inverseBindMatrices"); }},
      {"nodes of one name", [](json& g) { g["nodes"][1]["name"] = g["nodes"][2]["name"] = "j0"; }},
      {"nodes and clips without names",
       [](json& g) {
         for (json& node : g["nodes"]) node.erase("name");
         g["animations"][0].erase("name");
       }},
      {"integers that are written as fractions", [](json& g) { attribute_accessor(g, "POSITION")["componentType"] = 5126.0; }},
      {"a channel without a node", [](json& g) { channel(g, 1)["target"].erase("node"); }},
      {"no default scene", [](json& g) { g.erase("scene"); }},
      {"no scene", [](json& g) { g.erase("scene"), g.erase("scenes"); }},
      {"joints that are not in the scene", [](json& g) { g["scenes"][0]["nodes"] = {3}; }},
      {"nodes with the mesh that no scene has", add_nodes_of_no_scene},
      {"nodes with the mesh that another scene has than the default one",
       [](json& g) {
         add_nodes_of_no_scene(g);
         g["scenes"] = {{{"nodes", {5, 4}}}, {{"nodes", {0, 3}}}}, g["scene"] = 1;
       }},
      {"nodes with the mesh that another scene has than the first one, where none is the default",
       [](json& g) {
         add_nodes_of_no_scene(g);
         g["scenes"].push_back({{"nodes", {4, 5}}}), g.erase("scene");
       }},
      {"extensions of looks",
       [](json& g) {
         g["extensionsRequired"] = {"KHR_texture_transform", "KHR_materials_unlit"};
       }},
      {"images, materials and extras of any kind",
       [](json& g) {
         g["images"] = {{{"uri", "/dev/zero"}}, {{"bufferView", 99}}, 7};
         g["materials"] = g["textures"] = g["cameras"] = "none", primitive(g)["extras"] = {{"deep", {{"er", 1e300}}}};
       }},
      {"a joint twice",
       [](json& g) {
         g["skins"][0]["joints"] = {0, 1, 1};
       }},
      {"more values than keys", [](json& g) { g["accessors"][std::size_t(sampler(g, 1)["input"])]["count"] = 1; }},
      {"lines beside the triangles",
       [](json& g) {
         json lines = primitive(g);
         lines["mode"] = 1;
         g["meshes"][0]["primitives"].push_back(lines);
       }},
  };
}

void accessors_of_any_place(Suite& t) {
  t.example("the joints of a mesh may be the file's first accessor, and a single row may be at an offset", {}, [] {
    gen::RichGltf rich(false, false);
    json& description = rich.file.json;
    const json joints = description["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"];
    exchange_accessors(description, 0, joints.get<std::size_t>());
    // This is the one row of the fan's sparse positions, behind 12 other bytes.
    const std::size_t positions = description["meshes"][1]["primitives"][0]["attributes"]["POSITION"];
    const float row[] = {7, 7, 7, 0.03125f, 0.0625f, 0.125f};
    json& values = description["accessors"][positions]["sparse"]["values"];
    values = {{"bufferView", rich.file.add_view(row, sizeof row)}, {"byteOffset", 12}};
    const bool is_first = description["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] == 0;
    const std::string wrong = complaint(rich, model_of_scene(gltf_scene(rich.file.text_file(), "rich"), {Joints::rigid}));
    return Checked(is_first && wrong.empty(), 2, wrong);
  });
}

void files_of_all_features(Suite& t) {
  t.example(
      "a file of all features has each vertex where its formulas have it: rigid or not, with weights of targets that move or not",
      {}, [] {
        std::string wrong;
        for (const bool uneven : {false, true})
          for (const bool moving : {false, true}) {
            const gen::RichGltf rich(uneven, moving);
            const LoadOptions options{uneven ? Joints::affine : Joints::rigid, moving ? Morphs::moving : Morphs::constant};
            for (const std::string& bytes : {rich.file.text_file(), rich.file.binary_file()})
              wrong += complaint(rich, model_of_scene(gltf_scene(bytes, "rich"), options));
          }
        return Checked(wrong.empty(), 8, wrong);
      });
  t.example("a skin that scales unevenly is refused, or has its clip's sample refused where it is not rigid", {}, [] {
    const gen::RichGltf rich(true, false);
    const Scene scene = gltf_scene(rich.file.text_file(), "rich");
    const auto refused = [](const auto& action) -> std::string {
      try {
        action();
      } catch (const ModelError& e) {
        return e.what();
      }
      return "";
    };
    const std::string at_once = refused([&] { model_of_scene(scene); });
    const Model model = model_of_scene(scene, {Joints::affine});
    const std::string later = refused([&] { model.clips[0].sample(1); });
    const std::string expected = "rich: clip 'move', joint 'tip', time ";
    return Checked(at_once.starts_with(expected) && later.starts_with("rich: clip 'move', joint '") &&
                       refused([&] {
                         model_of_scene(gltf_scene(gen::RichGltf(false, false).file.text_file(), "rich")).clips[0].sample(1);
                       }).empty() &&
                       model.rigidity_defect > 1,
                   4, at_once + "; " + later + "; " + std::to_string(model.rigidity_defect));
  });
  t.example("where all joints are rigid an affine model is the rigid one, to the bit", {}, [] {
    const Scene scene = gltf_scene(gen::RichGltf(false, false).file.text_file(), "rich");
    const Model rigid = model_of_scene(scene), affine = model_of_scene(scene, {Joints::affine});
    return Checked(rigid.vertices == affine.vertices && rigid.rigidity_defect == affine.rigidity_defect);
  });
  t.example("a mesh that two nodes show with the same skin is there once, and twice where its weights move with one of them", {},
            [] {
              const auto count = [](bool moving) {
                return model_of_scene(gltf_scene(gen::RichGltf(false, moving).file.text_file(), "rich"),
                                      {Joints::rigid, Morphs::moving})
                    .triangles.size();
              };
              return Checked(count(false) == 18 && count(true) == 32, 2,
                             std::to_string(count(false)) + ", " + std::to_string(count(true)));
            });
}

// Makes a mesh of so many tubes, each a primitive. The weights of its vertices from the seventh on have these sums.
json tubes_of_sums(const std::vector<std::vector<float>>& sums) {
  gen::RiggedGltf rig = gen::bending_tube(3);
  rig.meshes.resize(sums.size(), rig.meshes[0]);
  for (std::size_t p = 0; p < sums.size(); ++p)
    for (std::size_t i = 0; i < sums[p].size(); ++i)
      rig.meshes[p].joints[0][7 + i] = {0, 2, 0, 0}, rig.meshes[p].weights[0][7 + i] = {sums[p][i] - 0.5f, 0.5f, 0, 0};
  json out = json::parse(gen::built(rig).text_file());
  for (std::size_t p = 1; p < sums.size(); ++p) out["meshes"][0]["primitives"].push_back(out["meshes"][p]["primitives"][0]);
  out["meshes"] = json::array({out["meshes"][0]});
  return out;
}

void notes_of_models(Suite& t) {
  const auto notes_of = [](const json& g) {
    std::string out;
    for (const std::string& note : model_of_scene(gltf_scene(g.dump(), "file.gltf")).notes) out += note + "\n";
    return out;
  };
  t.example("a model says what of its file is left out or changed, and nothing of a file that is as it should be", {}, [&] {
    json lines = tubes_of_sums({{1.0009f}});
    lines["meshes"][0]["primitives"].push_back(primitive(lines));
    lines["meshes"][0]["primitives"][1]["mode"] = 1;
    std::string found;
    for (const json& g : {tubes_of_sums({{1}}), tubes_of_sums({{0.9375f}}), lines}) found += notes_of(g);
    return Checked(found ==
                       "mesh 0: the weights of 1 vertices do not sum to 1 but are off by up to 0.062500; they are divided "
                       "by their sums\nmesh 0, primitive 1: has no triangles, and is left out\n",
                   3, found);
  });
  t.example("meshes that other scenes show, and rotations that are not of unit length, are told of", {}, [&] {
    json others = json::parse(gen::built(gen::bending_tube(3)).text_file());
    others["nodes"].push_back({{"mesh", 0}});
    others["scenes"].push_back({{"nodes", {others["nodes"].size() - 1}}});
    const std::string of_scene = notes_of(others);
    std::string of_rotation[2];
    for (const bool is_off : {false, true}) {
      gen::RiggedGltf rig = gen::bending_tube(3);
      for (gen::GltfTrack& track : rig.clips[0].tracks)
        for (float& x : track.values)
          if (track.path == "rotation") x *= is_off ? 1.005f : 1.000001f;
      of_rotation[is_off] = notes_of(json::parse(gen::built(rig).text_file()));
    }
    return Checked(
        of_scene ==
                "1 node that shows a mesh is not in the default scene, and left out; bounds do not have what other "
                "scenes show\n" &&
            of_rotation[0].empty() &&
            of_rotation[1].starts_with("clip 'bend': has rotations whose quaternions are not of unit length but off by up "
                                       "to 0.005"),
        3, of_scene + of_rotation[0] + of_rotation[1]);
  });
  t.example("a vertex that only triangles without three different vertices have is left out, and that is told", {}, [&] {
    gen::RiggedGltf rig = gen::bending_tube(3);
    const Model expected = model_of_scene(gltf_scene(gen::built(rig).text_file(), "file.gltf"));
    gen::GltfMesh& mesh = rig.meshes[0];
    const auto far = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back({100, 0, 0});
    mesh.joints[0].push_back({0, 0, 0, 0}), mesh.weights[0].push_back({1, 0, 0, 0});
    mesh.indices.insert(mesh.indices.begin(), {0, far, far, far, 1, far});
    const Model read = model_of_scene(gltf_scene(gen::built(rig).text_file(), "file.gltf"));
    const std::vector<int>& kept = read.sources[0].triangles;
    return Checked(read.vertices == expected.vertices && read.triangles == expected.triangles && kept[0] == -1 && kept[1] == -1 &&
                       kept[2] == 0 && read.sources[0].vertices.back() == -1 && expected.notes.empty() &&
                       read.notes.size() == 1 &&
                       read.notes[0] == "mesh 0: 2 of " + std::to_string(kept.size()) +
                                            " triangles have two equal vertices; they are left out, and so are vertices of no "
                                            "other triangle",
                   1, read.notes.empty() ? "" : read.notes[0]);
  });
  t.example("what a model says of a primitive's weights is of that primitive, whatever others are before it and behind it", {},
            [&] {
              const std::vector<std::vector<float>> kinds = {{1}, {0.9375f}, {1.03125f, 1.015625f, 0.96875f}};
              const std::string said[] = {"", "1 vertices do not sum to 1 but are off by up to 0.062500",
                                          "3 vertices do not sum to 1 but are off by up to 0.031250"};
              std::string wrong;
              for (std::size_t all = 0; all < 27; ++all) {
                const std::size_t of[] = {all % 3, all / 3 % 3, all / 9};
                std::string expected;
                for (int p = 0; p < 3; ++p)
                  if (!said[of[p]].empty())
                    expected += "mesh 0, primitive " + std::to_string(p) + ": the weights of " + said[of[p]] +
                                "; they are divided by their sums\n";
                const std::string found = notes_of(tubes_of_sums({kinds[of[0]], kinds[of[1]], kinds[of[2]]}));
                if (found != expected) wrong += "'" + found + "', not '" + expected + "'; ";
              }
              return Checked(wrong.empty(), 27, wrong);
            });
}

void nodes_that_show_one_mesh(Suite& t, const json& tube) {
  t.example("a mesh that three nodes show with the same skin is there once for each list of weights, and where these move it", {},
            [&] {
              json three = tube;
              add_target(three, 1);
              three["meshes"][0]["weights"] = {0.5};
              for (int copy = 0; copy < 2; ++copy) {
                three["scenes"][0]["nodes"].push_back(three["nodes"].size());
                three["nodes"].push_back(three["nodes"][3]);
              }
              const Model plain = model_of_scene(gltf_scene(tube.dump(), "file.gltf"));
              const double x = plain.vertices[plain.sources[0].vertices[2]][0];
              std::string wrong;
              for (int all = 0; all < 64; ++all) {
                json g = three;
                std::map<int, double> weights;  // by node
                std::set<double> distinct;
                for (const auto& [node, choice] : {std::pair{3, all % 4}, {4, all / 4 % 4}, {5, all / 16}}) {
                  if (choice > 0) g["nodes"][node]["weights"] = {0.5 * choice - 0.5};
                  weights[node] = choice > 0 ? 0.5 * choice - 0.5 : 0.5;
                  distinct.insert(weights[node]);
                }
                const Scene scene = gltf_scene(g.dump(), "file.gltf");
                const Model still = model_of_scene(scene), moving = model_of_scene(scene, {Joints::rigid, Morphs::moving});
                bool good = still.sources.size() == 3 && moving.sources.size() == 3 && moving.morphs.size() == distinct.size();
                for (const Model* model : {&still, &moving}) good = good && model->triangles.size() == 48 * distinct.size();
                for (const SourcePrimitive& source : still.sources)
                  good = good && still.vertices[source.vertices[2]][0] == x + weights[source.node];
                if (!good) wrong += std::to_string(all) + "; ";
              }
              return Checked(wrong.empty(), 64, wrong);
            });
}

void refused_and_unusual_descriptions(Suite& t, const json& tube) {
  t.example("of three nodes that show a mesh with the same skin, the one whose weights move has a mesh of its own", {}, [&] {
    json three = tube;
    add_target(three, 1);
    three["meshes"][0]["weights"] = {0.5};
    for (int copy = 0; copy < 2; ++copy) {
      for (json& scene : three["scenes"]) scene["nodes"].push_back(three["nodes"].size());
      three["nodes"].push_back(three["nodes"][3]);
    }
    json moving = three;
    move_weight(moving, 0.25, 0.75);
    const auto count = [](const json& g) {
      return model_of_scene(gltf_scene(g.dump(), "file.gltf"), {Joints::rigid, Morphs::moving}).triangles.size();
    };
    return Checked(count(three) == 48 && count(moving) == 96, 2,
                   std::to_string(count(three)) + ", " + std::to_string(count(moving)));
  });
  t.example("a description with one thing wrong is refused with the file, the thing and the reason", {}, [&] {
    std::string wrong = refusal(tube.dump());
    for (const Change& change : refused_changes()) {
      json changed = tube;
      change.change(changed);
      const std::string message = refusal(changed.dump()), expected = "file.gltf: " + change.reason;
      const bool is_expected = expected.ends_with(": ") ? message.starts_with(expected) : message == expected;
      if (!is_expected || message.ends_with("\n")) wrong += "'" + message + "', not '" + expected + "'; ";
    }
    return Checked(wrong.empty(), static_cast<long>(refused_changes().size()), wrong);
  });
  t.example("weights of morph targets are the node's own, or else the mesh's, and move the vertices where they rest", {}, [&] {
    json both = tube;
    add_target(both, 1);
    both["meshes"][0]["weights"] = {0.5};
    json own = both;
    own["nodes"][3]["weights"] = {0.25};
    const auto moved = [&](const json& g) {
      const Model plain = model_of_scene(gltf_scene(tube.dump(), "file.gltf")),
                  other = model_of_scene(gltf_scene(g.dump(), "file.gltf"));
      return (other.vertices[other.sources[0].vertices[2]] - plain.vertices[plain.sources[0].vertices[2]])[0];
    };
    json still = own, still_spline = own;
    move_weight(still, 0.25, 0.25), move_weight_along_spline(still_spline, 0, 0.25, 0);
    return Checked(moved(both) == 0.5 && moved(own) == 0.25 && moved(still) == 0.25 && moved(still_spline) == 0.25, 4);
  });
  t.example("what is unusual and right is read", {}, [&] {
    std::string wrong;
    for (const auto& [name, change] : accepted_changes()) {
      json changed = tube;
      change(changed);
      try {
        const Model model = model_of_scene(gltf_scene(changed.dump(), "file.gltf"), {Joints::affine});
        if (model.triangles.size() != 48 || model.clips.size() != 1 || model.sources.size() != 1 || model.sources[0].node != 3)
          wrong += std::string(name) + ": it is another model; ";
      } catch (const ModelError& e) {
        wrong += std::string(name) + ": " + e.what() + "; ";
      }
    }
    return Checked(wrong.empty(), static_cast<long>(accepted_changes().size()), wrong);
  });
}

void buffers_and_primitives_without_positions(Suite& t, const json& tube) {
  t.example("buffers are beside the file that names them, by names with percent signs, and nowhere else", {}, [&] {
    const TemporaryFolder folder;
    json g = tube;
    const std::string data = g["buffers"][0]["uri"];
    const auto write = [&](const std::string& name, const std::string& bytes) {
      std::ofstream(folder.file(name), std::ios::binary) << bytes;
    };
    const std::string glb = gen::built(gen::bending_tube(3)).binary_file();
    const std::size_t length = g["buffers"][0]["byteLength"];
    write("a b.bin", glb.substr(glb.size() - length));
    const auto is_read_from = [&](const char* uri) {
      g["buffers"][0]["uri"] = uri;
      return model_of_scene(gltf_scene(g.dump(), folder.file("file.gltf"))).triangles.size() == 48;
    };
    bool found = is_read_from("a%20b.bin");
    // A plus sign is no space, and a file may be longer than the buffer.
    write("a+b.bin", glb.substr(glb.size() - length) + "more"), write("a b.bin", std::string(length, 'x'));
    found = found && is_read_from("a+b.bin") && is_read_from("a%2Bb.bin");
    // The first of two buffers that are files is the other one.
    write("four.bin", "1234567");
    const json one = g;
    g["buffers"].push_back(g["buffers"][0]), g["buffers"][0] = {{"byteLength", 4}, {"uri", "four.bin"}};
    for (json& view : g["bufferViews"]) view["buffer"] = 1;
    found = found && model_of_scene(gltf_scene(g.dump(), folder.file("file.gltf"))).triangles.size() == 48;
    g = one;
    write("a b.bin", "too short");
    g["buffers"][0]["uri"] = "a%20b.bin";
    const auto refused = [&] {
      try {
        gltf_scene(g.dump(), folder.file("file.gltf"));
      } catch (const ModelError& e) {
        return std::string(e.what()).find("glTF description: tinygltf cannot read it: ") != std::string::npos;
      }
      return false;
    };
    bool good = refused();
    g["buffers"][0]["uri"] = "README.md";  // This is a file of the working directory.
    good = good && refused();
    return Checked(found && good, 6);
  });
  t.example("a data URI may have more bytes than the buffer, be it one, two or three, or digits that are no more than these", {},
            [&] {
              const std::string glb = gen::built(gen::bending_tube(3)).binary_file();
              const std::size_t length = tube["buffers"][0]["byteLength"];
              const Model expected = model_of_scene(gltf_scene(tube.dump(), "file.gltf"));
              for (std::size_t more = 0; more <= 7; ++more)
                // So lengths of all remainders by three come up.
                for (const bool is_cut : {false, true}) {
                  json g = tube;
                  const std::size_t own = length + (is_cut ? more : 0);
                  g["buffers"][0] = {{"byteLength", own},
                                     {"uri", "data:application/octet-stream;base64," +
                                                 gen::base64(glb.substr(glb.size() - length) + std::string(7, 'x'))}};
                  const Model read = model_of_scene(gltf_scene(g.dump(), "file.gltf"));
                  if (read.vertices != expected.vertices || read.triangles != expected.triangles)
                    return Checked(false, static_cast<long>(more), "another model");
                }
              return Checked(true, 16);
            });
  t.example("a primitive without positions is left out with a note", {}, [&] {
    json g = tube;
    json other = primitive(g);
    other["attributes"].erase("POSITION");
    g["meshes"][0]["primitives"].push_back(other);
    const Model expected = model_of_scene(gltf_scene(tube.dump(), "file.gltf")),
                read = model_of_scene(gltf_scene(g.dump(), "file.gltf"));
    return Checked(read.triangles == expected.triangles && read.notes.size() == expected.notes.size() + 1 &&
                       read.notes.back().find("primitive 1: has no triangles") != std::string::npos,
                   1, read.notes.empty() ? "" : read.notes.back());
  });
}

void skins_and_what_is_no_json(Suite& t, const json& tube) {
  t.example("one mesh with two skins is there for each of them, and joints are known by their nodes, not by names", {}, [&] {
    json g = tube;
    g["nodes"][1]["name"] = g["nodes"][2]["name"] = "j0";
    g["skins"].push_back({{"joints", {2, 1, 0}}});
    g["nodes"].push_back({{"mesh", 0}, {"skin", 1}});
    g["scenes"][0]["nodes"].push_back(4);
    const Model one = model_of_scene(gltf_scene(tube.dump(), "file.gltf")),
                two = model_of_scene(gltf_scene(g.dump(), "file.gltf"));
    return Checked(two.triangles.size() == 96 && two.sources.size() == 2 && two.sources[1].node == 4 &&
                       two.sources[1].skin == 1 && two.vertices.size() == 2 * one.vertices.size() - 4,
                   2,
                   std::to_string(two.triangles.size()) + " triangles, " + std::to_string(two.vertices.size()) + " vertices, " +
                       std::to_string(two.sources.size()) + " sources");
  });
  t.example("what is no JSON is refused with what the parser says", {}, [&] {
    bool good = true;
    for (const char* text : {"{", " {", "{\"asset\": {\"version\": 1e999}}", "{\xff\xfe"})
      good = good && refusal(text).starts_with("file.gltf: glTF description: ");
    for (const char* text : {"", " \n", "Hello", "[{", "\xff\xfe{}"})
      good = good && refusal(text) == "file.gltf: file: is neither binary glTF nor JSON";
    for (const char* before : {" \n", "\xef\xbb\xbf"}) good = good && refusal(before + tube.dump()).empty();
    // The file is nested far deeper than a stack is. Nothing descends into extras.
    std::string deep = tube.dump();
    deep.insert(1, "\"extras\":" + std::string(1000000, '[') + std::string(1000000, ']') + ",");
    good = good && refusal(tube.dump() + std::string(1, '\0')) == "file.gltf: glTF description: has a NUL character";
    const std::string twice = refusal("{\"scene\": 0, \"extras\": [{\"a\": {\"b\": 1}, \"b\": 2, \"a\": 3}]," +
                                      tube.dump().substr(1)),
                      apart = refusal("{\"extras\": [{\"a\": {\"a\": 1}, \"b\": 2}, {\"a\": 3}]," + tube.dump().substr(1));
    good = good && twice == "file.gltf: glTF description: has a name twice in one object: \"a\"" && apart.empty();
    return Checked(good && refusal(deep).empty(), 15, twice + apart);
  });
}

}  // namespace

PROPTEST(gltf_scene) {
  files_of_all_features(t);
  accessors_of_any_place(t);
  const json tube = json::parse(gen::built(gen::bending_tube(3)).text_file());
  notes_of_models(t);
  nodes_that_show_one_mesh(t, tube);
  refused_and_unusual_descriptions(t, tube);
  buffers_and_primitives_without_positions(t, tube);
  skins_and_what_is_no_json(t, tube);
}

}  // namespace proptests::suite_gltf_scene
