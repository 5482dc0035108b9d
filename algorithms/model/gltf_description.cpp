// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/gltf_description.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "algorithms/model/model.hpp"
#include "algorithms/runtime/tree/glb_file.hpp"

namespace refitlab {
namespace {

using nlohmann::json;

constexpr std::int64_t greatest_index = std::numeric_limits<std::int32_t>::max();

// These are required extensions that say how a surface looks, and the one of geometry that is read.
constexpr const char* readable_extensions[] = {"KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_",
                                               "KHR_lights_",    "EXT_lights_",  "KHR_xmp",      "KHR_mesh_quantization"};

// Kind says what a member of an object may be.
enum class Kind { index, text, flag, numbers, indices, attributes };

struct Member {
  const char* name;
  Kind kind;
};

class Description {
 public:
  Description(const json& whole, bool has_binary, const std::string& file)
      : whole_(whole),
        has_binary_(has_binary),
        file_(file) {}

  json geometry() const {
    check_version();
    check_extensions();
    json out = {{"asset", {{"version", "2.0"}}}};
    copy(whole_, "file", {{"scene", Kind::index}}, out);
    for (const char* extension : {"extensionsUsed", "extensionsRequired"})
      if (uses(extension, "KHR_mesh_quantization")) out["extensionsUsed"] = {"KHR_mesh_quantization"};
    take_list(
        "buffers", "buffer", [this](const json& from, const std::string& thing) { return buffer(from, thing); }, out);
    take_list("bufferViews", "buffer view",
              {{"buffer", Kind::index}, {"byteOffset", Kind::index}, {"byteLength", Kind::index}, {"byteStride", Kind::index}},
              out);
    take_list(
        "accessors", "accessor", [this](const json& from, const std::string& thing) { return accessor(from, thing); }, out);
    take_list(
        "meshes", "mesh", [this](const json& from, const std::string& thing) { return mesh(from, thing); }, out);
    take_list(
        "nodes", "node", [this](const json& from, const std::string& thing) { return node(from, thing); }, out);
    take_list("scenes", "scene", {{"nodes", Kind::indices}}, out);
    take_list(
        "skins", "skin", [this](const json& from, const std::string& thing) { return skin(from, thing); }, out);
    take_list(
        "animations", "clip", [this](const json& from, const std::string& thing) { return animation(from, thing); }, out);
    return out;
  }

 private:
  [[noreturn]] void refuse(const std::string& thing, const std::string& reason) const { throw ModelError(file_, thing, reason); }

  const json* member(const json& object, const char* name) const {
    const auto found = object.find(name);
    return found == object.end() ? nullptr : &*found;
  }

  bool has_extension(const json& object, const char* name) const {
    const json* extensions = member(object, "extensions");
    return extensions && extensions->contains(name);
  }

  const json& list(const json& object, const char* name, const std::string& thing) const {
    static const json none = json::array();
    const json* found = member(object, name);
    if (found && !found->is_array()) refuse(thing, std::string("'") + name + "' is not a list");
    return found ? *found : none;
  }

  void check_version() const {
    const json* asset = whole_.is_object() ? member(whole_, "asset") : nullptr;
    const json* version = asset && asset->is_object() ? member(*asset, "version") : nullptr;
    if (!version || !version->is_string()) refuse("file", "says no version of glTF");
    const std::string text = version->get<std::string>();
    if (!text.starts_with("2.")) refuse("file", "glTF of version " + text.substr(0, 20) + ", not 2");
    // A file may be of a later version and still be read as 2.0, unless it says that this is not enough.
    const json* least = member(*asset, "minVersion");
    if (!least || *least == "2.0") return;
    if (!least->is_string()) refuse("file", "'minVersion' is not a version of glTF");
    refuse("file", "needs glTF of version " + least->get<std::string>().substr(0, 20) + ", and 2.0 is what is read");
  }

  bool uses(const char* members, const char* extension) const {
    const json& names = list(whole_, members, "file");
    return std::any_of(names.begin(), names.end(), [&](const json& name) { return name == extension; });
  }

  void check_extensions() const {
    for (const json& name : list(whole_, "extensionsRequired", "file")) {
      if (!name.is_string()) refuse("file", "'extensionsRequired' is not a list of names");
      const std::string text = name.get<std::string>();
      const bool readable = std::any_of(std::begin(readable_extensions), std::end(readable_extensions),
                                        [&](const char* prefix) { return text.starts_with(prefix); });
      if (!readable) refuse("file", "needs the extension " + text.substr(0, 80) + ", which is not read");
    }
  }

  json checked(const json& value, const Member& m, const std::string& thing) const {
    const auto is_not = [&](const char* what) { refuse(thing, std::string("'") + m.name + "' is not " + what); };
    switch (m.kind) {
      case Kind::index: return index(value, m.name, thing);
      case Kind::text:
        if (!value.is_string()) is_not("a text");
        return value;
      case Kind::flag:
        if (!value.is_boolean()) is_not("true or false");
        return value;
      case Kind::numbers:
        if (!value.is_array()) is_not("a list of numbers");
        for (const json& x : value)
          if (!x.is_number()) is_not("a list of numbers");
        return value;
      case Kind::indices: {
        if (!value.is_array()) is_not("a list of indices");
        json out = json::array();
        for (const json& x : value) out.push_back(index(x, m.name, thing));
        return out;
      }
      case Kind::attributes: break;
    }
    if (!value.is_object()) is_not("an object");
    json out = json::object();
    for (const auto& [name, accessor] : value.items())
      if (name == "POSITION" || name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_"))
        out[name] = index(accessor, m.name, thing);
    return out;
  }

  // JSON has one type of numbers: 5126.0 is an integer too.
  json index(const json& value, const char* name, const std::string& thing) const {
    const double number = value.is_number() ? value.get<double>() : -1;
    if (!(number >= 0 && number <= static_cast<double>(greatest_index)) ||
        number != static_cast<double>(static_cast<std::int64_t>(number)))
      refuse(thing, std::string("'") + name + "' is not an integer from 0 to " + std::to_string(greatest_index));
    return static_cast<std::int64_t>(number);
  }

  void copy(const json& from, const std::string& thing, const std::vector<Member>& members, json& to) const {
    if (!from.is_object()) refuse(thing, "is not an object of the description");
    for (const Member& m : members)
      if (const json* value = member(from, m.name)) to[m.name] = checked(*value, m, thing);
  }
  json copied(const json& from, const std::string& thing, const std::vector<Member>& members) const {
    json out = json::object();
    copy(from, thing, members, out);
    return out;
  }

  template <class Take>
  void take_list(const char* name, const std::string& kind, const Take& take, json& to) const {
    to[name] = json::array();
    for (const json& from : list(whole_, name, "file")) {
      const std::string thing = kind + " " + std::to_string(to[name].size());
      to[name].push_back(take(from, thing));
    }
  }
  void take_list(const char* name, const std::string& kind, const std::vector<Member>& members, json& to) const {
    take_list(
        name, kind, [&](const json& from, const std::string& thing) { return copied(from, thing, members); }, to);
  }

  json buffer(const json& from, const std::string& thing) const {
    json out = copied(from, thing, {{"byteLength", Kind::index}, {"uri", Kind::text}});
    if (!from.contains("uri") && has_extension(from, "EXT_meshopt_compression"))
      refuse(thing, "has its bytes compressed by EXT_meshopt_compression, which is not read");
    const bool in_file = has_binary_ && &from == &whole_.at("buffers").front();
    if ((!out.contains("uri") && !in_file) || out.value("uri", "x").empty() || out.value("byteLength", 0) == 0)
      refuse(thing, "has no bytes");
    if (out.contains("uri")) out["uri"] = uri_of(out["uri"], out["byteLength"]);
    return out;
  }

  static std::string uri_of(std::string uri, std::size_t length) {
    if (!uri.starts_with("data:")) {
      for (std::size_t at = 0; (at = uri.find('+', at)) != std::string::npos;) uri.replace(at, 1, "%2B");
      return uri;
    }
    // Three bytes are four digits, and one or two of them are two or three, with "=" for the others.
    const std::size_t first = uri.find(',') + 1, digits = (8 * length + 5) / 6, all = (length + 2) / 3 * 4;
    if (first > 0 && uri.size() >= first + digits) uri.resize(first + digits), uri.resize(first + all, '=');
    return uri;
  }

  json node(const json& from, const std::string& thing) const {
    json out = copied(from, thing,
                      {{"name", Kind::text},
                       {"children", Kind::indices},
                       {"matrix", Kind::numbers},
                       {"translation", Kind::numbers},
                       {"rotation", Kind::numbers},
                       {"scale", Kind::numbers},
                       {"mesh", Kind::index},
                       {"skin", Kind::index},
                       {"weights", Kind::numbers}});
    if (has_extension(from, "EXT_mesh_gpu_instancing"))
      refuse(thing, "is shown in the places of EXT_mesh_gpu_instancing, which is not read");
    return out;
  }

  json accessor(const json& from, const std::string& thing) const {
    json out = copied(from, thing,
                      {{"bufferView", Kind::index},
                       {"byteOffset", Kind::index},
                       {"componentType", Kind::index},
                       {"normalized", Kind::flag},
                       {"count", Kind::index},
                       {"type", Kind::text}});
    const json* sparse = member(from, "sparse");
    if (!sparse) return out;
    out["sparse"] = copied(*sparse, thing, {{"count", Kind::index}});
    for (const char* part : {"indices", "values"}) {
      const json* found = member(*sparse, part);
      if (!found) refuse(thing, std::string("is sparse without ") + part);
      out["sparse"][part] =
          copied(*found, thing, {{"bufferView", Kind::index}, {"byteOffset", Kind::index}, {"componentType", Kind::index}});
    }
    return out;
  }

  json mesh(const json& from, const std::string& thing) const {
    json out = copied(from, thing, {{"name", Kind::text}, {"weights", Kind::numbers}});
    out["primitives"] = json::array();
    for (const json& p : list(from, "primitives", thing)) {
      const std::string at = thing + ", primitive " + std::to_string(out["primitives"].size());
      json primitive = copied(p, at, {{"attributes", Kind::attributes}, {"indices", Kind::index}, {"mode", Kind::index}});
      if (has_extension(p, "KHR_draco_mesh_compression"))
        refuse(at, "is compressed by KHR_draco_mesh_compression, which is not read");
      for (const json& target : list(p, "targets", at))
        primitive["targets"].push_back(checked(target, {"targets", Kind::attributes}, at));
      out["primitives"].push_back(primitive);
    }
    return out;
  }

  json skin(const json& from, const std::string& thing) const {
    json out = copied(from, thing, {{"joints", Kind::indices}, {"inverseBindMatrices", Kind::index}});
    // Missing matrices are identities, but tinygltf would complain about them.
    if (!out.contains("inverseBindMatrices")) out["inverseBindMatrices"] = -1;
    return out;
  }

  json animation(const json& from, const std::string& thing) const {
    json out = copied(from, thing, {{"name", Kind::text}});
    out["channels"] = out["samplers"] = json::array();
    std::size_t number = 0;
    for (const json& c : list(from, "channels", thing)) {
      const std::string at = thing + ", channel " + std::to_string(number++);
      json channel = copied(c, at, {{"sampler", Kind::index}});
      const json* target = member(c, "target");
      if (!target) refuse(at, "has no target");
      channel["target"] = copied(*target, at, {{"node", Kind::index}, {"path", Kind::text}});
      if (has_extension(*target, "KHR_animation_pointer")) refuse(at, "moves what KHR_animation_pointer says, which is not read");
      if (channel["target"].contains("node")) out["channels"].push_back(channel);
    }
    for (const json& s : list(from, "samplers", thing)) {
      const std::string at = thing + ", sampler " + std::to_string(out["samplers"].size());
      out["samplers"].push_back(copied(s, at, {{"input", Kind::index}, {"output", Kind::index}, {"interpolation", Kind::text}}));
    }
    return out;
  }

  const json& whole_;
  bool has_binary_;
  const std::string& file_;
};

// Parses JSON in which no object has a name twice, as glTF 2.0 (2.7.1) demands: some readers take the first of the two, others the
// last.
json parsed_description(const std::string& text, const std::string& path) {
  std::vector<std::set<std::string>> names;  // of the objects that are open, from the outermost one
  return json::parse(text, [&](int, json::parse_event_t event, const json& parsed) {
    if (event == json::parse_event_t::object_start) names.emplace_back();
    if (event == json::parse_event_t::object_end) names.pop_back();
    if (event == json::parse_event_t::key && !names.back().insert(parsed.get_ref<const std::string&>()).second)
      throw ModelError(path, "glTF description", "has a name twice in one object: " + parsed.dump().substr(0, 60));
    return true;
  });
}

}  // namespace

GltfGeometry gltf_geometry(const std::string& bytes, const std::string& path) {
  const bool is_binary = bytes.starts_with("glTF");
  if (!is_binary && bytes.find('\0') != std::string::npos) throw ModelError(path, "glTF description", "has a NUL character");
  std::vector<GlbChunk> chunks = is_binary ? read_glb(bytes, path) : std::vector<GlbChunk>{{json_chunk, bytes}};
  if (bytes.size() > static_cast<std::size_t>(greatest_index)) throw ModelError(path, "file", "is larger than 2 GB");
  json whole;
  try {
    whole = parsed_description(chunks[0].data, path);
  } catch (const json::exception& e) {
    const std::string& text = chunks[0].data;
    const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
    if (first == std::string::npos || text[first] != '{') throw ModelError(path, "file", "is neither binary glTF nor JSON");
    throw ModelError(path, "glTF description", std::string(e.what()).substr(0, 200));
  }
  const bool has_binary = chunks.size() > 1 && chunks[1].type == bin_chunk && !chunks[1].data.empty();
  chunks.resize(has_binary ? 2 : 1);
  const json geometry = Description(whole, has_binary, path).geometry();
  chunks[0].data = geometry.dump();
  GltfGeometry out{glb_of(chunks, path), {}};
  for (const json& buffer : geometry.at("buffers"))
    if (buffer.contains("uri") && !buffer["uri"].get_ref<const std::string&>().starts_with("data:"))
      out.lengths.push_back(buffer["byteLength"]);
  return out;
}

}  // namespace refitlab
