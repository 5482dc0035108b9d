// SPDX-License-Identifier: GPL-3.0-or-later
// The page calls these functions. Settings go in as JSON, and numbers come out as JSON, or long lists as places in memory.
//
// Each function returns a text that is valid until the next call of the same function. An error is {"error": "…"}.
#include <emscripten.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/eigen.hpp>

#include "algorithms/methods/refit/compared_variants.hpp"
#include "experiments/explorer/explorer.hpp"
#include "experiments/explorer/pages/all.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/scenes/twist.hpp"

namespace {

using nlohmann::json;
using namespace refitlab;

using Exact = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
double as_double(const Exact& x) { return x.convert_to<double>(); }

// A SharedList has numbers that the page reads where they lie.
template <class T>
class SharedList {
 public:
  std::vector<T> values;
  json place() const { return {{"at", reinterpret_cast<std::uintptr_t>(values.data())}, {"count", values.size()}}; }
};

Explorer& the_explorer() {
  static Explorer the_one;
  return the_one;
}

std::vector<std::uint8_t>& packed_model() {
  static std::vector<std::uint8_t> the_one;
  return the_one;
}

template <class Make>
const char* answer(std::string& text, Make&& make) {
  try {
    text = make().dump();
  } catch (const std::exception& e) {
    text = json{{"error", e.what()}}.dump();
  }
  return text.c_str();
}

ExplorerSettings settings_of(const char* text) {
  const json j = json::parse(text);
  return {j.at("model"), j.at("variant"), j.at("clip"), j.at("time"), j.at("joint"), j.at("twist"), j.at("level"), j.at("ball")};
}

}  // namespace

extern "C" {

// Returns the memory for a packed model of so many bytes, for add_model.
EMSCRIPTEN_KEEPALIVE std::uint8_t* room_for_model(int bytes) {
  packed_model().resize(bytes);
  return packed_model().data();
}

// Adds the model that was put there, and returns its name: {"name"}.
EMSCRIPTEN_KEEPALIVE const char* add_model() {
  static std::string text;
  return answer(text, [] {
    the_explorer().add(packed_model());
    return json{{"name", the_explorer().models().back()}};
  });
}

// Returns the names of models, variants and pages.
EMSCRIPTEN_KEEPALIVE const char* catalog() {
  static std::string text;
  return answer(text, [] {
    json out{{"models", the_explorer().models()}};
    for (const RefitVariant& v : compared_variants()) out["variants"].push_back({{"name", v.name}, {"sound", v.sound}});
    for (const auto& live : explorer::live_pages<Exact>()) {
      const explorer::Page& p = live.page;
      json page{{"id", p.id}, {"title", p.title}, {"text", p.text}};
      for (const auto& s : p.sliders)
        page["sliders"].push_back({{"label", s.label}, {"low", s.low}, {"high", s.high}, {"start", s.start}});
      for (const auto& preset : p.presets) page["presets"].push_back({{"label", preset.label}, {"values", preset.values}});
      out["pages"].push_back(page);
    }
    return out;
  });
}

// Returns a model's joints, clips and triangles. Makes the model, which may take seconds.
EMSCRIPTEN_KEEPALIVE const char* character(const char* model) {
  static std::string text;
  static SharedList<int> triangles;
  return answer(text, [&] {
    const AnimatedCharacter& c = the_explorer().character(model);
    triangles.values.clear();
    for (const Triangle& t : c.mesh.triangles) triangles.values.insert(triangles.values.end(), t.begin(), t.end());
    json out{{"triangles", triangles.place()},
             {"levels", c.tree.level_count()},
             {"twist_joint", twist_joint(c.mesh)},
             {"joints", json::array()},
             {"clips", json::array()}};
    for (const Joint& j : c.mesh.joints) out["joints"].push_back(j.name);
    for (const Clip& clip : c.clips) out["clips"].push_back({{"name", clip.name}, {"duration", clip.duration}});
    return out;
  });
}

// Returns a view. The fields are those of ExplorerSettings and ExplorerView.
EMSCRIPTEN_KEEPALIVE const char* view(const char* settings) {
  static std::string text;
  static SharedList<float> vertices, balls;
  static SharedList<std::uint8_t> outside, misses;
  return answer(text, [&] {
    const ExplorerView v = the_explorer().view(settings_of(settings));
    vertices.values.clear(), balls.values.clear();
    for (const Point3& p : v.vertices)
      for (int i = 0; i < 3; ++i) vertices.values.push_back(static_cast<float>(p[i]));
    for (const auto& b : v.balls) {
      for (int i = 0; i < 3; ++i) balls.values.push_back(static_cast<float>(b.center[i]));
      balls.values.push_back(static_cast<float>(b.radius));
    }
    outside.values.assign(v.outside.begin(), v.outside.end());
    misses.values.assign(v.misses.begin(), v.misses.end());
    json out{{"vertices", vertices.place()},
             {"balls", balls.place()},
             {"outside", outside.place()},
             {"misses", misses.place()},
             {"axis", {v.axis[0], v.axis[1], v.axis[2]}},
             {"level_count", v.level_count},
             {"ball", v.ball},
             {"ball_vertices", v.ball_vertices},
             {"ball_optimal", v.ball_optimal}};
    for (const Point3& p : v.joints) out["joints"].push_back({p[0], p[1], p[2]});
    for (const VariantSummary& s : v.summaries)
      out["summaries"].push_back({{"variant", s.variant},
                                  {"balls", s.balls},
                                  {"undefined", s.undefined},
                                  {"vertices_outside", s.vertices_outside},
                                  {"worst_miss", s.worst_miss},
                                  {"mean_radius", s.mean_radius},
                                  {"mean_over_optimal", s.mean_over_optimal},
                                  {"ball_radius", s.ball_radius}});
    return out;
  });
}

// Returns the scene of a page. values is a JSON list of its sliders' values.
EMSCRIPTEN_KEEPALIVE const char* scene(const char* page, const char* values) {
  static std::string text;
  return answer(text, [&] { return explorer::page_scene<Exact>(page, json::parse(values).get<std::vector<int>>(), as_double); });
}

}  // extern "C"
