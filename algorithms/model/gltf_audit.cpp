// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/gltf_audit.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "algorithms/model/model.hpp"

namespace refitlab {
namespace {

using nlohmann::json;

constexpr int ushort_component = 5123, uint_component = 5125, float_component = 5126;

// Of a file that ends: a device or a pipe need not.
std::string read_bytes(const std::filesystem::path& path, const std::string& file, const std::string& thing) {
  std::error_code error;
  std::ifstream in;
  if (std::filesystem::is_regular_file(path, error)) in.open(path, std::ios::binary);
  if (!in.is_open()) throw ModelError(file, thing, "cannot be read");
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw ModelError(file, thing, "cannot be read");
  return bytes;
}

std::string decode_base64(const std::string& text) {
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    const int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                      : c >= 'a' && c <= 'z' ? c - 'a' + 26
                      : c >= '0' && c <= '9' ? c - '0' + 52
                      : c == '+'             ? 62
                      : c == '/'             ? 63
                                             : -1;
    if (digit < 0) continue;  // padding at the end
    group = group << 6 | static_cast<std::uint32_t>(digit);
    if ((bits += 6) >= 8) bytes += static_cast<char>(group >> (bits -= 8) & 255);
  }
  return bytes;
}

class Audit {
 public:
  Audit(const std::string& bytes, const std::string& file) : file_(file) { read(bytes); }

  void run() const {
    for (std::size_t i = 0; i < list("skins").size(); ++i) check_skin(i);
    for (std::size_t i = 0; i < list("animations").size(); ++i) check_animation(i);
    std::map<std::size_t, int> skin_of_mesh;
    for (const json& node : list("nodes")) {
      if (!node.contains("mesh")) continue;
      check_mesh(node);
      const int skin = node.value("skin", -1);
      if (skin_of_mesh.try_emplace(node.at("mesh"), skin).first->second != skin)
        throw ModelError(file_, "node '" + node.value("name", "") + "'", "shares its mesh with a node of another skin");
    }
  }

 private:
  // A table of numbers inside a buffer, `width` numbers a row.
  struct Table {
    const char* first;
    std::size_t count, width, stride;
    int component;
    double at(std::size_t row, std::size_t column) const {
      const char* p = first + row * stride;
      const auto as = [&](auto value) {
        std::memcpy(&value, p + column * sizeof value, sizeof value);
        return static_cast<double>(value);
      };
      return component == float_component    ? as(float{})
             : component == uint_component   ? as(std::uint32_t{})
             : component == ushort_component ? as(std::uint16_t{})
                                             : as(std::uint8_t{});
    }
  };

  void read(const std::string& bytes) {
    std::string text = bytes;
    std::optional<std::string> binary;
    if (bytes.starts_with("glTF")) {
      const auto word = [&](std::size_t at) {
        std::uint32_t value = 0;
        if (at + 4 > bytes.size()) throw ModelError(file_, "file", "ends early");
        std::memcpy(&value, bytes.data() + at, 4);
        return std::size_t{value};
      };
      if (word(4) != 2) throw ModelError(file_, "file", "glTF of version " + std::to_string(word(4)) + ", not 2");
      if (word(8) > bytes.size()) throw ModelError(file_, "file", "ends early");
      const auto chunk = [&](std::size_t at) {
        if (at + 8 + word(at) > bytes.size()) throw ModelError(file_, "file", "ends early");
        return bytes.substr(at + 8, word(at));
      };
      text = chunk(12);
      const std::size_t next = 20 + text.size();
      if (next + 8 <= bytes.size()) binary = chunk(next);
    }
    json_ = json::parse(text);
    const std::string version = json_.at("asset").at("version");
    if (!version.starts_with("2")) throw ModelError(file_, "file", "glTF of version " + version + ", not 2");
    for (const json& buffer : list("buffers")) {
      const std::string uri = buffer.value("uri", "");
      const std::string thing = "buffer " + std::to_string(buffers_.size());
      const std::size_t comma = uri.find(',');
      if (uri.empty() && !binary) throw ModelError(file_, thing, "has no bytes");
      buffers_.push_back(uri.empty() ? *binary
                         : uri.starts_with("data:")
                             ? decode_base64(uri.substr(comma + 1))
                             : read_bytes(std::filesystem::path(file_).parent_path() / uri, file_, thing + " (" + uri + ")"));
    }
  }

  const json& list(const char* key) const {
    static const json none = json::array();
    const auto found = json_.find(key);
    return found == json_.end() ? none : *found;
  }

  Table table(std::size_t accessor, const std::string& thing) const {
    const json& a = json_.at("accessors").at(accessor);
    if (!a.contains("bufferView") || a.contains("sparse"))
      throw ModelError(file_, thing, "accessor " + std::to_string(accessor) + " is sparse, compressed or without data");
    const json& view = json_.at("bufferViews").at(a.at("bufferView").get<std::size_t>());
    const std::string type = a.at("type");
    Table t;
    t.component = a.at("componentType");
    t.count = a.at("count");
    t.width = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "MAT4" ? 16 : 4;
    const std::size_t size = t.component == float_component || t.component == uint_component ? 4
                             : t.component == ushort_component                               ? 2
                                                                                             : 1;
    t.stride = view.value("byteStride", t.width * size);
    const std::size_t start = view.value("byteOffset", std::size_t{0}) + a.value("byteOffset", std::size_t{0});
    const std::size_t index = view.at("buffer");
    if (index >= buffers_.size())
      throw ModelError(file_, thing, "accessor " + std::to_string(accessor) + " is in a buffer that there is not");
    const std::string& buffer = buffers_[index];
    const std::size_t room = start <= buffer.size() ? buffer.size() - start : 0;
    const std::size_t row = t.width * size;
    if (t.count > 0 && (row > room || (t.stride > 0 && t.count - 1 > (room - row) / t.stride)))
      throw ModelError(file_, thing, "accessor " + std::to_string(accessor) + " reaches past the end of its buffer");
    t.first = buffer.data() + start;
    return t;
  }
  Table float_table(std::size_t accessor, const std::string& thing) const {
    const Table t = table(accessor, thing);
    if (t.component != float_component)
      throw ModelError(file_, thing, "accessor " + std::to_string(accessor) + " is not of floats, which assimp needs");
    return t;
  }

  // Such as "mesh 2 'body'".
  std::string label(const std::string& kind, const json& object, std::size_t index) const {
    const std::string name = object.value("name", "");
    return kind + " " + std::to_string(index) + (name.empty() ? "" : " '" + name + "'");
  }

  void check_skin(std::size_t index) const {
    const json& skin = list("skins").at(index);
    const std::string thing = label("skin", skin, index);
    if (!skin.contains("inverseBindMatrices")) throw ModelError(file_, thing, "no inverse bind matrices");
    const std::size_t count = float_table(skin.at("inverseBindMatrices"), thing).count;
    if (count < skin.at("joints").size())
      throw ModelError(
          file_, thing,
          "only " + std::to_string(count) + " inverse bind matrices for " + std::to_string(skin.at("joints").size()) + " joints");
  }

  void check_animation(std::size_t index) const {
    const json& animation = list("animations").at(index);
    const std::string thing = label("clip", animation, index);
    for (const json& channel : animation.at("channels")) {
      if (channel.at("target").at("path") == "weights") continue;  // of morph targets
      const json& sampler = animation.at("samplers").at(channel.at("sampler").get<std::size_t>());
      const std::size_t times = float_table(sampler.at("input"), thing).count;
      const std::size_t values = float_table(sampler.at("output"), thing).count;
      const std::size_t needed = sampler.value("interpolation", "LINEAR") == "CUBICSPLINE" ? 3 * times : times;
      if (times == 0 || values < needed)
        throw ModelError(file_, thing,
                         "a channel has " + std::to_string(times) + " times but " + std::to_string(values) + " values");
    }
  }

  void check_mesh(const json& node) const {
    const std::size_t index = node.at("mesh");
    const json& mesh = json_.at("meshes").at(index);
    const std::string thing = label("mesh", mesh, index);
    for (const json& primitive : mesh.at("primitives")) {
      const json& attributes = primitive.at("attributes");
      const std::size_t count = float_table(attributes.at("POSITION"), thing).count;
      if (count == 0) throw ModelError(file_, thing, "is empty");
      if (primitive.contains("indices")) {
        const Table indices = table(primitive.at("indices"), thing);
        for (std::size_t i = 0; i < indices.count; ++i)
          if (indices.at(i, 0) >= static_cast<double>(count))
            throw ModelError(file_, thing, "index " + std::to_string(i) + " names a vertex out of range");
      }
      if (node.contains("skin"))
        check_influences(attributes, count, json_.at("skins").at(node.at("skin").get<std::size_t>()).at("joints").size(), thing);
    }
  }

  void check_influences(const json& attributes, std::size_t vertices, std::size_t skin_joints, const std::string& thing) const {
    std::optional<int> component;
    for (int set = 0;; ++set) {
      const std::string suffix = "_" + std::to_string(set);
      if (attributes.contains("JOINTS" + suffix) != attributes.contains("WEIGHTS" + suffix))
        throw ModelError(file_, thing, "joints and weights of set " + std::to_string(set) + " do not go together");
      if (!attributes.contains("JOINTS" + suffix)) break;
      const Table joints = table(attributes.at("JOINTS" + suffix), thing);
      const Table weights = float_table(attributes.at("WEIGHTS" + suffix), thing);
      if (joints.count != vertices || weights.count != vertices || joints.width != 4 || weights.width != 4 ||
          component.value_or(joints.component) != joints.component)
        throw ModelError(file_, thing, "joints and weights of set " + std::to_string(set) + " do not fit the vertices");
      component = joints.component;
      const auto refuse = [&](std::size_t v, const std::string& reason) {
        throw ModelError(file_, thing + ", vertex " + std::to_string(v), reason);
      };
      for (std::size_t v = 0; v < vertices; ++v)
        for (std::size_t k = 0; k < 4; ++k) {
          const double weight = weights.at(v, k), joint = joints.at(v, k);
          if (!std::isfinite(weight)) refuse(v, "a weight is not a finite number");
          if (weight < 0) refuse(v, "weight " + std::to_string(weight) + " is negative");
          if (weight > 0 && joint >= static_cast<double>(skin_joints))
            refuse(v, "joint index " + std::to_string(static_cast<long>(joint)) + " is out of range 0.." +
                          std::to_string(skin_joints - 1));
        }
    }
  }

  std::string file_;
  json json_;
  std::vector<std::string> buffers_;
};

}  // namespace

void audit_gltf(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".glb" || extension == ".gltf" || extension == ".GLB" || extension == ".GLTF")
    audit_gltf_bytes(read_bytes(path, path, "file"), path);
}

void audit_gltf_bytes(const std::string& bytes, const std::string& path) try {
  Audit(bytes, path).run();
} catch (const json::exception& e) {
  throw ModelError(path, "glTF description", std::string(e.what()).substr(0, 200));
}

}  // namespace refitlab
