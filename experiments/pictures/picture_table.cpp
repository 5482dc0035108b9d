// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pictures/picture_table.hpp"

#include <cmath>
#include <iostream>

#include "experiments/pictures/character_scene.hpp"

namespace refitlab {
namespace {

std::string css(const render::Color& c) {
  const auto byte = [](double x) { return std::to_string(std::lround(255 * x)); };
  return "rgb(" + byte(c.red) + "," + byte(c.green) + "," + byte(c.blue) + ")";
}

}  // namespace

void PictureTable::draw(const render::Scene& scene, const render::Camera& camera, render::Options options,
                        const PictureSubject& subject, const std::string& file, const std::vector<PictureNumber>& numbers,
                        const std::vector<PictureLabel>& labels) {
  for (int* side : {&options.width, &options.height}) *side = static_cast<int>(std::lround(size_ * *side));
  options.outline *= size_;
  std::cout << "[pictures] " << folder_ << "/" << file << std::endl;
  render::draw(scene, camera, options).write_png(folder_ + "/" + file);
  empty_ = false;
  const auto add = [&](const PictureNumber& n) {
    pictures_.add({"pictures", subject.model, subject.pose, subject.variant,
                   subject.level ? std::to_string(subject.level) : "all", n.quantity, format_number(n.value), n.unit,
                   subject.figure, file});
  };
  add({"width", static_cast<double>(options.width), "pixel"});
  add({"height", static_cast<double>(options.height), "pixel"});
  for (const PictureNumber& n : numbers) add(n);
  for (const PictureLabel& label : labels) {
    const auto at = camera.project(label.at, options.width, options.height);
    labels_.add({file, label.text, format_number(at[0]), format_number(at[1])});
  }
}

void PictureTable::write(const std::function<std::string(const std::string&)>& result) const {
  pictures_.write(result("pictures.csv"));
  labels_.write(result("picture_labels.csv"));
  ResultFile colors({"meaning", "color"});
  for (const auto& [meaning, color] : {std::pair{"holding", figure_colors::holding}, std::pair{"missing", figure_colors::missing},
                                       std::pair{"without", figure_colors::without}, std::pair{"idle", figure_colors::idle},
                                       std::pair{"touching", figure_colors::touching}})
    colors.add({meaning, css(color)});
  colors.write(result("picture_colors.csv"));
}

}  // namespace refitlab
