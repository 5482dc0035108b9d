#include "experiments/report/pictures.hpp"

#include <cmath>
#include <iostream>
#include <sstream>

#include "algorithms/results/write_whole.hpp"
#include "experiments/report/html.hpp"

namespace refitlab {
namespace {

std::string css(const render::Color& c) {
  const auto byte = [](double x) { return std::to_string(std::lround(255 * x)); };
  return "rgb(" + byte(c.red) + "," + byte(c.green) + "," + byte(c.blue) + ")";
}

}  // namespace

Picture rendered(const render::Scene& scene, const render::Camera& camera, const render::Options& options,
                 const std::string& caption, const std::string& path, const std::vector<Label>& labels) {
  std::cout << "[pictures] " << path << std::endl;
  render::draw(scene, camera, options).write_png(path);
  const int width = options.width, height = options.height;
  const std::string size = " width=\"" + std::to_string(width) + "\" height=\"" + std::to_string(height) + "\"",
                    data = "\"data:image/png;base64," + base64(read_whole(path)) + "\"";
  if (labels.empty())
    return {caption, "<div class=\"tile\"><img loading=\"lazy\" alt=\"" + escape_html(caption) + "\"" + size +
                         " src=" + data + "></div>"};
  std::ostringstream out;
  out << "<div class=\"tile\"><svg class=\"labelled\" role=\"img\" aria-label=\"" << escape_html(caption)
      << "\" viewBox=\"0 0 " << width << ' ' << height << "\"><image" << size << " href=" << data << "/>";
  for (const Label& label : labels) {
    const auto at = camera.project(label.at, width, height);
    out << "<text x=\"" << format("%.1f", at[0] + 9) << "\" y=\"" << format("%.1f", at[1] - 9) << "\">"
        << escape_html(label.text) << "</text>";
  }
  out << "</svg></div>";
  return {caption, out.str()};
}

std::string figure_section(const std::vector<Figure>& figures) {
  if (figures.empty()) return "";
  std::ostringstream out;
  out << "<h2>Pictures</h2>\n";
  for (const Figure& f : figures) {
    out << "<h3>" << escape_html(f.title) << "</h3>\n<p>" << f.text << "</p>\n";
    if (!f.legend.empty()) out << "<ul class=\"legend\">";
    for (const auto& [color, meaning] : f.legend)
      out << "<li><i style=\"background:" << css(color) << "\"></i>" << escape_html(meaning) << "</li>";
    if (!f.legend.empty()) out << "</ul>\n";
    out << "<div class=\"gallery\" style=\"--columns:" << f.columns << ";--phone:" << f.phone_columns << "\">\n";
    for (const Picture& p : f.pictures)
      out << "<figure>" << p.html << "<figcaption>" << escape_html(p.caption) << "</figcaption></figure>\n";
    out << "</div>\n";
  }
  return out.str();
}

}  // namespace refitlab
