#include "experiments/report/pictures.hpp"

#include <iostream>

#include "algorithms/refit/variants.hpp"
#include "algorithms/results/write_whole.hpp"
#include "algorithms/skinning/skin.hpp"
#include "experiments/render/draw.hpp"

namespace refitlab {
namespace {

std::string base64(const std::string& bytes) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) out += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
  }
  return out;
}

std::string embed_file(const std::string& path) {
  return "data:image/png;base64," + base64(read_whole(path));
}

// What a row of the figure shows: a skin and how its balls come about.
struct Row {
  std::string label;
  std::vector<Point3> vertices;
  std::vector<Ball3<double>> balls;
};

render::Camera frame_all(const std::vector<Row>& rows) {
  render::Box3 box;
  for (const Row& row : rows)
    for (const Point3& v : row.vertices) box.extend(v);
  return render::Camera::frame(box, {0.55, 0.25, 1}, 0.8);
}

}  // namespace

std::vector<Picture> twist_pictures(const Character& c, const std::string& posture_name, const Posture& posture,
                                    const std::string& folder) {
  std::vector<Row> rows(1);
  rows[0] = {"reference posture, smallest balls", c.model.vertices, {}};
  for (const TreeNode& n : c.tree.nodes) rows[0].balls.push_back(n.reference);
  const auto add = [&](const std::string& label, const RefitVariant& variant) {
    const auto pose = make_skinning_pose(c.model, c.sets, posture, variant.skinning);
    rows.push_back({posture_name + ", " + label, skin(c.model, c.sets, pose, variant.skinning), c.refit_all(variant, pose)});
  };
  add("linear blending, refitted by [Kavan and Zara 2005a]", refit_variant("linear"));
  add("spherical blending, refitted by Algorithm 1 repaired", refit_variant("spherical_repaired"));
  add("spherical blending, refitted by control hulls per joint-set", refit_variant("control_sets_exact"));

  const render::Camera camera = frame_all(rows);
  std::vector<Picture> pictures;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (const int level : {0, 4, 6}) {  // 0: the bare skin
      render::Scene scene;
      render::MeshShape mesh;
      mesh.vertices = rows[r].vertices;
      mesh.triangles = c.model.triangles;
      scene.meshes.push_back(std::move(mesh));
      for (std::size_t n = 0; level > 0 && n < c.tree.nodes.size(); ++n)
        if (c.tree.nodes[n].level == level) scene.balls.push_back({rows[r].balls[n], render::palette::blue, 0.12});
      const std::string path = folder + "/" + c.model.name + "_" + std::to_string(r) + "_level" + std::to_string(level) + ".png";
      std::cout << "[pictures] " << path << std::endl;
      render::draw(scene, camera, {.width = 480, .height = 600}).write_png(path);
      pictures.push_back({c.model.name + ": " + rows[r].label + (level ? ", level " + std::to_string(level) : ""), embed_file(path)});
    }
  return pictures;
}

}  // namespace refitlab
