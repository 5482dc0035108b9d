// The run's own models in the page, for the explorer.
#pragma once

#include <string>
#include <vector>

#include "algorithms/model/model.hpp"

namespace refitlab {

class PackedModels {
 public:
  // Procedural models are not packed: the explorer makes them itself. What would make the page too large is left out.
  void add(const Model& model);
  // HTML to stand before the explorer: the models, and which were left out.
  std::string html() const;

 private:
  std::string lines_;                  // base64, a line a model
  std::vector<std::string> left_out_;  // by name
};

}  // namespace refitlab
