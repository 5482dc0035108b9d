// SPDX-License-Identifier: GPL-3.0-or-later
// A PictureTable has the pictures of a run, drawn as PNG files, and the tables that say what each of them shows.
//
// Which pictures are a figure, their captions and legends are the report's matter (experiments/report/pictures.py).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "algorithms/results/result_file.hpp"
#include "experiments/render/draw.hpp"

namespace refitlab {

// A PictureSubject says what a picture shows. level is one of the tree, or 0 if the picture shows none.
struct PictureSubject {
  std::string figure, model, pose, variant;
  int level = 0;
};

// A PictureNumber was counted or measured when the picture was made.
struct PictureNumber {
  std::string quantity;
  double value;
  std::string unit = "1";
};

// A PictureLabel is a word beside a point of the scene.
struct PictureLabel {
  Point3 at;
  std::string text;
};

class PictureTable {
 public:
  // folder is for the PNG files. Pictures have this share of the width and height that they are drawn with otherwise.
  PictureTable(std::string folder, double size) : folder_(std::move(folder)), size_(size) {}
  // Draws on white, which the page's style turns into its own ground, to a file of the folder, and adds the picture's rows.
  void draw(const render::Scene& scene, const render::Camera& camera, render::Options options, const PictureSubject& subject,
            const std::string& file, const std::vector<PictureNumber>& numbers = {},
            const std::vector<PictureLabel>& labels = {});
  bool empty() const { return empty_; }
  // Writes pictures.csv, picture_labels.csv (where words stand, in pixels from the upper left) and picture_colors.csv. result
  // returns the path of a table of this run, by name.
  void write(const std::function<std::string(const std::string&)>& result) const;

 private:
  std::string folder_;
  double size_;
  bool empty_ = true;
  ResultFile pictures_{{"experiment", "model", "pose", "variant", "level", "quantity", "value", "unit", "figure", "file"}};
  ResultFile labels_{{"file", "label", "x", "y"}};
};

}  // namespace refitlab
