// Pictures and figures of the report: drawn by the project, embedded in the page.
#pragma once

#include <string>
#include <vector>

#include "experiments/render/draw.hpp"

namespace refitlab {

struct Picture {
  std::string caption;
  std::string html;  // an <img> or <svg>; nothing outside the page is needed
};

// What a colour means, beside its swatch.
struct LegendEntry {
  render::Color color;
  std::string meaning;
};

// Pictures that belong together, under a heading.
struct Figure {
  std::string title, text;  // text: HTML
  std::vector<LegendEntry> legend;
  std::vector<Picture> pictures;
  int columns = 3, phone_columns = 2;
};

// A word beside a point of the scene.
struct Label {
  Point3 at;
  std::string text;
};

// Draws on white, which the page's style turns into its own ground, writes the PNG to path and embeds it.
Picture rendered(const render::Scene& scene, const render::Camera& camera, const render::Options& options,
                 const std::string& caption, const std::string& path, const std::vector<Label>& labels = {});

std::string figure_section(const std::vector<Figure>& figures);

}  // namespace refitlab
