// SPDX-License-Identifier: GPL-3.0-or-later
// Tests what is refused of scenes that no file of the other tests can contain.
#include "algorithms/model/model_of_scene.hpp"

#include <cmath>
#include <functional>
#include <memory>

#include "algorithms/model/assimp_scene.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_model_of_scene {
namespace {

using namespace refitlab;

aiNode* node(const char* name, aiNode* parent) {
  auto* out = new aiNode(name);
  if (parent) parent->addChildren(1, &out);
  return out;
}

aiMesh* triangle(const char* bone) {
  auto* mesh = new aiMesh;
  mesh->mName = "skin";
  mesh->mNumVertices = 3;
  mesh->mVertices = new aiVector3D[3]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh->mNumFaces = 1;
  mesh->mFaces = new aiFace[1];
  mesh->mFaces[0].mNumIndices = 3;
  mesh->mFaces[0].mIndices = new unsigned[3]{0, 1, 2};
  if (!bone) return mesh;
  mesh->mNumBones = 1;
  mesh->mBones = new aiBone* [1] { new aiBone };
  mesh->mBones[0]->mName = bone;
  mesh->mBones[0]->mNumWeights = 3;
  mesh->mBones[0]->mWeights = new aiVertexWeight[3]{{0, 1}, {1, 1}, {2, 1}};
  return mesh;
}

aiNodeAnim* still(const char* name) {
  auto* channel = new aiNodeAnim;
  channel->mNodeName = name;
  channel->mNumPositionKeys = 1;
  channel->mPositionKeys = new aiVectorKey[1]{{0, {0, 0, 0}}};
  return channel;
}

// Makes a scene whose root has the two meshes, a skinned triangle and one without bones on the node "plain", and a clip of two
// channels.
std::unique_ptr<aiScene> scene() {
  auto out = std::make_unique<aiScene>();
  out->mRootNode = node("root", nullptr);
  aiNode* const plain = node("plain", out->mRootNode);
  out->mRootNode->mNumMeshes = plain->mNumMeshes = 1;
  out->mRootNode->mMeshes = new unsigned[1]{0};
  plain->mMeshes = new unsigned[1]{1};
  out->mNumMeshes = 2;
  out->mMeshes = new aiMesh* [2] { triangle("root"), triangle(nullptr) };
  out->mNumAnimations = 1;
  out->mAnimations = new aiAnimation* [1] { new aiAnimation };
  out->mAnimations[0]->mName = "clip";
  out->mAnimations[0]->mDuration = 1;
  out->mAnimations[0]->mNumChannels = 2;
  out->mAnimations[0]->mChannels = new aiNodeAnim* [2] { still("root"), still("plain") };
  return out;
}

std::string refusal(const aiScene& of) {
  try {
    check_assimp_scene(of, "file");
    model_of_scene(convert_scene(of, "file"));
  } catch (const ModelError& e) {
    return e.what();
  }
  return "";
}

void set_positions(aiScene& s, double first, double second) {
  aiNodeAnim& channel = *s.mAnimations[0]->mChannels[0];
  delete[] channel.mPositionKeys;
  channel.mNumPositionKeys = 2;
  channel.mPositionKeys = new aiVectorKey[2]{{first, {0, 0, 0}}, {second, {0, 0, 0}}};
}

void set_rotation(aiScene& s, float w) {
  aiNodeAnim& channel = *s.mAnimations[0]->mChannels[0];
  channel.mNumRotationKeys = 1;
  channel.mRotationKeys = new aiQuatKey[1]{{0, aiQuaternion(w, 0, 0, 0)}};
}

struct Broken {
  std::function<void(aiScene&)> break_it;
  std::string message;
};

std::vector<Broken> broken_scenes() {
  return {
      {[](aiScene& s) { s.mNumMeshes = 0; }, "file: has no mesh"},
      {[](aiScene& s) { s.mMeshes[0]->mNumFaces = 0; }, "mesh 'skin': is empty"},
      {[](aiScene& s) { s.mMeshes[0]->mFaces[0].mIndices[2] = 3; }, "mesh 'skin': face 0 names a vertex out of range"},
      {[](aiScene& s) { s.mMeshes[0]->mBones[0]->mWeights[1].mVertexId = 3; },
       "mesh 'skin', vertex 3: a bone names a vertex out of range"},
      {[](aiScene& s) { s.mMeshes[0]->mBones[0]->mWeights[1].mWeight = NAN; },
       "mesh 'skin', vertex 1: a weight is not a finite number"},
      {[](aiScene& s) { s.mMeshes[0]->mBones[0]->mWeights[1].mWeight = -1; },
       "mesh 'skin', vertex 1: weight -1.000000 is negative"},
      {[](aiScene& s) { s.mRootNode->mMeshes[0] = 2; }, "node 'root': names a mesh out of range"},
      {[](aiScene& s) { s.mMeshes[0]->mVertices[1].y = NAN; }, "mesh 'skin': the position of vertex 1 is not finite"},
      {[](aiScene& s) { s.mRootNode->mChildren[0]->mName = "root"; }, "node 'root': two nodes have this name"},
      {[](aiScene& s) { s.mMeshes[0]->mBones[0]->mOffsetMatrix.d1 = 1; }, "bone 'root': its offset matrix is not affine"},
      {[](aiScene& s) { s.mMeshes[0]->mBones[0]->mName = "nobody"; }, "bone 'nobody': no node has this name"},
      {[](aiScene& s) { s.mRootNode->mTransformation.a1 = NAN; }, "node 'root': its transform is not finite"},
      {[](aiScene& s) { s.mAnimations[0]->mDuration = -1; }, "clip 'clip': its duration is not a time"},
      {[](aiScene& s) { s.mAnimations[0]->mDuration = INFINITY; }, "clip 'clip': its duration is not a time"},
      {[](aiScene& s) { s.mAnimations[0]->mDuration = NAN; }, "clip 'clip': its duration is not a time"},
      {[](aiScene& s) { s.mAnimations[0]->mChannels[1]->mNodeName = "root"; }, "clip 'clip', joint 'root': two channels move it"},
      {[](aiScene& s) { s.mAnimations[0]->mChannels[0]->mPositionKeys[0].mValue.x = NAN; },
       "clip 'clip', joint 'root', key 0 at 0.000000 s: not finite, or a rotation by a zero quaternion"},
      {[](aiScene& s) { set_rotation(s, 1e-7f); },
       "clip 'clip', joint 'root', key 0 at 0.000000 s: not finite, or a rotation by a zero quaternion"},
      {[](aiScene& s) { set_positions(s, 1, 0); },
       "clip 'clip', joint 'root', key 1 at 0.000000 s: keys are not in order of time"},
      {[](aiScene& s) {
         s.mRootNode->mChildren[0]->mNumMeshes = 0;
         s.mAnimations[0]->mChannels[0]->mNodeName = "nobody";
         aiMatrix4x4::Scaling({0, 0, 0}, s.mRootNode->mTransformation);
       },
       "clip 'clip', joint 'root', time 0 s: the skin matrix is not finite"},
  };
}

// Returns the number of the scene's joints if its mesh has two bones of one node, whose offsets differ by this length.
std::size_t joints_of_two_bones(double apart) {
  const auto s = scene();
  aiMesh& mesh = *s->mMeshes[0];
  aiBone* const first = mesh.mBones[0];
  auto* const second = new aiBone;
  second->mName = first->mName;
  second->mOffsetMatrix.a4 = static_cast<ai_real>(apart);
  second->mNumWeights = 3;
  second->mWeights = new aiVertexWeight[3]{{0, 0.5}, {1, 0.5}, {2, 0.5}};
  for (unsigned w = 0; w < 3; ++w) first->mWeights[w].mWeight = 0.5;
  delete[] mesh.mBones;
  mesh.mBones = new aiBone* [2] { first, second };
  mesh.mNumBones = 2;
  return model_of_scene(convert_scene(*s, "memory")).joints.size();
}

void what_a_flat_joint_does_to_others(Suite& t) {
  t.example("a mesh beside a joint that is flat at rest, or nearly so, is where its node has it", {}, [] {
    const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
    const std::vector<Eigen::Vector3d> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Eigen::Vector3d at(1, 0, 0);
    long tried = 0;
    for (const double scale : {0., 1e-300, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1.})
      for (int flat = 1; flat < 8; ++flat) {
        Eigen::Vector3d scales = Eigen::Vector3d::Ones();
        for (int i = 0; i < 3; ++i)
          if (flat >> i & 1) scales[i] = scale;
        const auto turned = [](double angle, const Eigen::Vector3d& axis) {
          return Eigen::Matrix3d(Eigen::AngleAxisd(angle, axis.normalized()));
        };
        Eigen::Matrix4d joint = identity, offset = identity, place = identity;
        joint.topLeftCorner<3, 3>() = turned(0.7, {1, 1, 0.3}) * scales.asDiagonal();
        offset.topLeftCorner<3, 3>() = turned(0.9, {1, -2, 0.5});
        place.topRightCorner<3, 1>() = at;
        Scene s{"file", {{"joint", -1, joint}, {"skinned", -1, identity}, {"rigid", -1, place}}, {}, {}, {}, {}};
        s.meshes = {{{{"skinned", corners, {{0, 1, 2}}, {{{0, 1.}}, {{0, 1.}}, {{0, 1.}}}}}},
                    {{{"rigid", corners, {{0, 1, 2}}}}}};
        s.skins = {{{0}, {offset}}};
        s.shown = {{1, 0, 0}, {2, 1, -1}};
        const Model model = model_of_scene(s, {.joints = Joints::affine});
        const auto matrices = skin_matrices(model.skeleton, Animation{}, 0);
        for (const Eigen::Vector3d& corner : corners) {
          double nearest = 1;
          for (std::size_t v = 0; v < model.vertices.size(); ++v) {
            const Eigen::Matrix4d& m = matrices[static_cast<std::size_t>(model.influences[v][0].joint)];
            nearest = std::min(nearest, ((m * model.vertices[v].homogeneous()).head<3>() - corner - at).norm());
          }
          ++tried;
          if (nearest > 1e-8) return Checked(false, tried, std::to_string(scale) + ": " + std::to_string(nearest));
        }
      }
    return Checked(true, tried);
  });
}

void what_has_no_triangle_and_what_has(Suite& t) {
  t.example("a skinned mesh without a triangle is not there, nor is its skin", {}, [] {
    Scene s = convert_scene(*scene(), "file");
    s.meshes[0].primitives[0].triangles.clear();
    try {
      model_of_scene(s);
    } catch (const ModelError& e) {
      return Checked(e.what() == std::string("file: file: no triangle: of the meshes that have bones, none has triangles"), 1,
                     e.what());
    }
    return Checked(false, 1, "it is accepted");
  });
  t.example(
      "a triangle of vertices that only the rounding of weights makes one is there, and so is each of its vertices", {}, [] {
        Scene s{"file", {{"root", -1, Eigen::Matrix4d::Identity()}, {"joint", 0, Eigen::Matrix4d::Identity()}}, {}, {}, {}, {}};
        const Eigen::Vector3d origin = Eigen::Vector3d::Zero(), far(100, 0, 0);
        const std::vector<std::pair<int, double>> even = {{0, 0.25}, {1, 0.75}},
                                                  nearly = {{0, 0.25 + 0x1p-27}, {1, 0.75 - 0x1p-27}};
        s.meshes = {{{{"mesh 0", {origin, origin, far, origin}, {{0, 1, 2}, {0, 3, 2}}, {even, nearly, even, even}}}}};
        s.skins = {{{0, 1}, {Eigen::Matrix4d::Identity(), Eigen::Matrix4d::Identity()}}};
        s.shown = {{0, 0, 0}};
        const Model model = model_of_scene(s);
        bool are_rounded = model.vertices.size() == 3;  // the fourth is the first
        for (const auto& list : model.influences)
          are_rounded = are_rounded && list.size() == 2 && list[0].weight == 0.25 && list[1].weight == 0.75;
        return Checked(are_rounded && model.triangles.size() == 1 && model.vertices[model.triangles[0][2]] == far &&
                           model.sources[0].triangles == std::vector<int>{0, -1},
                       2);
      });
}

}  // namespace

PROPTEST(model_of_scene) {
  t.example("the morph targets that assimp has are not read, and a note says so", {}, [] {
    const auto with = scene();
    aiMesh& mesh = *with->mMeshes[0];
    mesh.mNumAnimMeshes = 2;
    mesh.mAnimMeshes = new aiAnimMesh* [2] { new aiAnimMesh, new aiAnimMesh };
    const std::vector<std::string> none = model_of_scene(convert_scene(*scene(), "file")).notes,
                                   notes = model_of_scene(convert_scene(*with, "file")).notes;
    return Checked(none.empty() && notes.size() == 1 &&
                       notes[0] == "mesh 'skin': has 2 morph targets, which are read from glTF alone, and are left out",
                   2);
  });
  t.example("two bones of one node are one joint where their offsets do the same, and else are two", {}, [] {
    const std::size_t one = joints_of_two_bones(0);
    return Checked(joints_of_two_bones(1e-15) == one && joints_of_two_bones(1e-7) == one + 1 &&
                       joints_of_two_bones(1e-5) == one + 1 && joints_of_two_bones(1e-3) == one + 1,
                   5);
  });
  t.example("a skinned mesh that two nodes show is there once, and comes from both of them", {}, [] {
    const auto s = scene();
    for (aiNode* of : {s->mRootNode, s->mRootNode->mChildren[0]}) {
      const unsigned first = of->mMeshes[0];
      delete[] of->mMeshes;
      of->mNumMeshes = 2;
      of->mMeshes = new unsigned[2]{first, 1 - first};
    }
    const Model model = model_of_scene(convert_scene(*s, "memory"));
    std::string sources;
    for (const SourcePrimitive& source : model.sources)
      sources += std::to_string(source.node) + std::to_string(source.mesh) + std::to_string(source.triangles[0]) + " ";
    return Checked(sources == "000 011 112 100 " && model.triangles.size() == 3, 4, sources);
  });
  t.example("accepted at the edge: keys that coincide, a quaternion of any length but nearly 0, a clip without a duration", {},
            [] {
              const std::function<void(aiScene&)> changes[] = {
                  [](aiScene& s) { set_positions(s, 1, 1); }, [](aiScene& s) { set_rotation(s, 1e-5f); },
                  [](aiScene& s) { set_rotation(s, 1e5f); }, [](aiScene& s) { s.mAnimations[0]->mDuration = 0; }};
              std::string wrong;
              for (const auto& change : changes) {
                const auto s = scene();
                change(*s);
                wrong += refusal(*s);
              }
              return Checked(wrong.empty(), 4, wrong);
            });
  t.example("a mesh below a node that a scale of 0 hides is there, in the node's own frame", {}, [] {
    const auto s = scene();
    s->mRootNode->mChildren[0]->mTransformation.a1 = 0;
    const Model model = model_of_scene(convert_scene(*s, "memory"), {.joints = Joints::affine});
    const aiMesh& plain = *s->mMeshes[s->mRootNode->mChildren[0]->mMeshes[0]];
    long found = 0;
    for (unsigned v = 0; v < plain.mNumVertices; ++v)
      found += std::find(model.vertices.begin(), model.vertices.end(),
                         Point3(plain.mVertices[v].x, plain.mVertices[v].y, plain.mVertices[v].z)) != model.vertices.end();
    return Checked(found == static_cast<long>(plain.mNumVertices) && found > 0, found);
  });
  what_has_no_triangle_and_what_has(t);
  what_a_flat_joint_does_to_others(t);
  t.example("a scene with one thing wrong is refused with the file, the thing and the reason", {}, [] {
    std::string wrong = refusal(*scene());
    for (const Broken& broken : broken_scenes()) {
      const auto s = scene();
      broken.break_it(*s);
      const std::string message = refusal(*s);
      if (message != "file: " + broken.message) wrong += "'" + message + "', not '" + broken.message + "'; ";
    }
    return Checked(wrong.empty(), static_cast<long>(broken_scenes().size()), wrong);
  });
}

}  // namespace proptests::suite_model_of_scene
