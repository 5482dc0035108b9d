// Skin matrices of a moving skeleton as rigid transforms.
#include "algorithms/model/skeleton_motion.hpp"

#include <cmath>

#include "proptests/harness.hpp"

namespace proptests {
namespace {

using namespace refitlab;

double real() { return *rc::gen::inRange(-1000, 1001) / 1000.0; }

// Posed by a matrix as its only skin matrix.
PosedSkeleton pose_by(const Eigen::Matrix4d& matrix) {
  const BoundSkeleton skeleton{"test", {{"node", -1, matrix}}, {{"joint", 0, -1, Eigen::Matrix4d::Identity()}}};
  return pose(skeleton, Motion{}, 0);
}

}  // namespace

PROPTEST(skeleton_motion) {
  t.holds("a matrix that is a rotation but for a small symmetric stretch is posed by that very rotation",
          {.number_type = "double", .degenerate_at_least = 0.05}, [] {
            const Eigen::Vector4d drawn(real(), real(), real(), real());
            RC_PRE(drawn.norm() > 0.01);
            const Eigen::Quaterniond turn(Eigen::Vector4d(drawn.normalized()));
            const double size = *rc::gen::element(0.0, 1e-6, 1e-4, 5e-4);
            RC_CLASSIFY(size == 0, "degenerate");
            Eigen::Matrix3d stretch = Eigen::Matrix3d::Identity();
            for (int i = 0; i < 3; ++i)
              for (int k = i; k < 3; ++k) stretch(i, k) = stretch(k, i) = stretch(i, k) + size * real();
            Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
            matrix.topLeftCorner<3, 3>() = turn.toRotationMatrix() * stretch;
            matrix.topRightCorner<3, 1>() = Eigen::Vector3d(real(), real(), real());

            const PosedSkeleton posed = pose_by(matrix);
            const auto& q = posed.posture[0].rotation;
            const Eigen::Vector4d expected(turn.w(), turn.x(), turn.y(), turn.z());
            RC_ASSERT(std::min((q - expected).norm(), (q + expected).norm()) < 1e-13);
            RC_ASSERT(posed.posture[0].translation == Eigen::Vector3d(matrix.topRightCorner<3, 1>()));
            const double defect = (stretch * stretch - Eigen::Matrix3d::Identity()).norm();
            RC_ASSERT(std::abs(posed.rigidity_defect - defect) < 1e-14);
            RC_ASSERT((turn.toRotationMatrix() - matrix.topLeftCorner<3, 3>()).norm() <= posed.rigidity_defect + 1e-14);
          });
  t.example("key times begin at 0, end at the duration, hold every key between, and are thinned evenly", {}, [] {
    Motion motion{"clip", 10, {{0, {}, {}, {}}}};
    for (int k = -1; k <= 11; ++k) motion.tracks[0].scales.push_back({k + 0.5, Eigen::Vector3d::Ones()});
    const std::vector<double> all = key_times(motion, 12), some = key_times(motion, 4);
    return Checked(all == std::vector<double>{0, 0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5, 9.5, 10} &&
                       some == std::vector<double>{0, 2.5, 6.5, 10},
                   2);
  });
  t.example("before its first key and after its last a node stays", {}, [] {
    const Eigen::Vector3d ones = Eigen::Vector3d::Ones(), zeros = Eigen::Vector3d::Zero();
    const Motion motion{
        "clip", 4, {{0, {{1, zeros}, {3, 2 * ones}}, {{0, Eigen::Quaterniond::Identity()}}, {{0, ones}}}}};
    const std::vector<SceneNode> nodes = {{"node", -1, Eigen::Matrix4d::Identity()}};
    bool good = true;
    for (const auto& [time, x] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.5, 0.5}, {2.5, 1.5}, {3.0, 2.0}, {4.0, 2.0}})
      good = good && global_transforms(nodes, motion, time)[0](1, 3) == x;
    return Checked(good, 6);
  });
}

}  // namespace proptests
