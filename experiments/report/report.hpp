// The report: one self-contained HTML page with the pictures, plots and tables of a run.
#pragma once

#include <string>
#include <vector>

#include "experiments/collisions/collisions.hpp"
#include "experiments/growth/characters.hpp"
#include "experiments/growth/joints.hpp"
#include "experiments/growth/triangles.hpp"
#include "experiments/queries/queries.hpp"
#include "experiments/report/pictures.hpp"
#include "experiments/rounding/rounding.hpp"
#include "experiments/speed/batch.hpp"
#include "experiments/speed/speed.hpp"
#include "experiments/tightness/tightness.hpp"
#include "experiments/tightness/volumes.hpp"

namespace refitlab {

struct Report {
  std::vector<std::string> absent_models;
  std::vector<Figure> figures;
  std::string explorer;  // the HTML of explorer/build; empty: none
  std::string reference;  // the folder of the teaching reference, from the page; empty: none
  std::vector<TightnessResult> tightness;
  std::vector<SpeedResult> speed;
  std::vector<BatchSpeed> batches;
  VolumeResults volumes;
  std::vector<RoundingResult> rounding;
  std::vector<CollisionResult> collisions;
  std::vector<TriangleGrowth> triangle_growth;
  std::vector<JointGrowth> joint_growth;
  std::vector<CharacterGrowth> character_growth;
  std::vector<QueryResult> queries;
  std::string verdicts;  // the path of verdicts.csv, which may not be there
};

void write_report(const Report& report, const std::string& path);

}  // namespace refitlab
