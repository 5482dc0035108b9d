// SPDX-License-Identifier: GPL-3.0-or-later
// All pages of lemmas are here, by their ids.
#pragma once

#include "experiments/explorer/pages/lemma1.hpp"
#include "experiments/explorer/pages/lemma2.hpp"
#include "experiments/explorer/pages/lemma3.hpp"
#include "experiments/explorer/pages/lemma4.hpp"
#include "experiments/explorer/pages/lemma5.hpp"
#include "experiments/explorer/pages/whole_sphere.hpp"

namespace refitlab::explorer {

template <class S>
struct LivePage {
  Page page;
  void (*scene)(const Values&, Scene<S>&);
};

template <class S>
const std::vector<LivePage<S>>& live_pages() {
  static const std::vector<LivePage<S>> pages{{lemma1_page(), lemma1_scene<S>}, {lemma2_page(), lemma2_scene<S>},
                                              {lemma3_page(), lemma3_scene<S>}, {lemma4_page(), lemma4_scene<S>},
                                              {lemma5_page(), lemma5_scene<S>}, {whole_sphere_page(), whole_sphere_scene<S>}};
  return pages;
}

// Returns the scene of a page for these values, which are brought into the sliders' ranges, with a "texts" of the values. Throws
// std::invalid_argument for an unknown id or another number of values than there are sliders.
template <class S>
nlohmann::json page_scene(const std::string& id, Values values, std::function<double(const S&)> as_double) {
  for (const LivePage<S>& live : live_pages<S>()) {
    if (live.page.id != id) continue;
    const auto& sliders = live.page.sliders;
    if (values.size() != sliders.size()) throw std::invalid_argument("page '" + id + "' has another number of sliders");
    auto texts = nlohmann::json::array();
    for (std::size_t i = 0; i < sliders.size(); ++i) {
      values[i] = std::clamp(values[i], sliders[i].low, sliders[i].high);
      texts.push_back(sliders[i].text(values[i]));
    }
    Scene<S> scene(std::move(as_double));
    live.scene(values, scene);
    nlohmann::json out = scene.json();
    out["texts"] = texts;
    return out;
  }
  throw std::invalid_argument("no page '" + id + "'");
}

}  // namespace refitlab::explorer
