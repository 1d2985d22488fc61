// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/pose_refinement.hpp"

#include <gtest/gtest.h>

#include "support/box_world.hpp"
#include "support/key_frames.hpp"

namespace segdf {
namespace {

/// Two scans of a street with a house across its end, 1 m apart.
class PoseRefinement : public ::testing::Test {
 protected:
  PoseRefinement() {
    test::BoxWorld world = test::makeStreet();
    world.add(30.0, 0.0, 1.0, 12.0, 5.0);
    from_ = test::makeKeyFrame(world.scan(0.0, 0.0, 0.0, 1), config_);
    to_ = test::makeKeyFrame(world.scan(1.0, 0.2, 3.0, 2), config_);
  }

  PairPose refine(const Pose& given) const {
    return refinePair(given, thinForRegistration(from_->scan.points, from_->seg.roles),
                      PlaneMap(to_->scan.points, to_->seg.roles));
  }
  Pose truth() const { return to_->scan.pose.inverse() * from_->scan.pose; }

  Config config_;
  std::unique_ptr<KeyFrame> from_;
  std::unique_ptr<KeyFrame> to_;
};

TEST_F(PoseRefinement, APoseThatFitsStays) {
  const PairPose pair = refine(truth());
  EXPECT_FALSE(pair.refined) << "nothing to gain";
  EXPECT_TRUE(pair.to_T_from.isApprox(truth()));
  EXPECT_GT(pair.quality, 0.9);
}

TEST_F(PoseRefinement, AnErrorOfDecimetresIsMended) {
  const Pose wrong = Eigen::Translation3d(0.25, -0.2, 0.1) *
                     Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitZ()) * truth();
  const PairPose pair = refine(wrong);
  EXPECT_TRUE(pair.refined);
  const Pose error = pair.to_T_from * truth().inverse();
  // Scans without noise: what is left is the sampling of the planes.
  EXPECT_LT(error.translation().norm(), 0.02);
  EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), 0.001);
}

TEST_F(PoseRefinement, AHopelessPoseComesBackWithItsPoorQuality) {
  const Pose wrong = Eigen::Translation3d(6.0, 4.0, 0.5) *
                     Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()) * truth();
  const PairPose pair = refine(wrong);
  EXPECT_FALSE(pair.refined) << "farther than a refinement may go";
  EXPECT_TRUE(pair.to_T_from.isApprox(wrong));
  EXPECT_LT(pair.quality, DynamicConfig{}.min_quality) << "the pair will be dropped";
}

TEST_F(PoseRefinement, NothingToMatchIsNoQuality) {
  EXPECT_EQ(refinePair(truth(), {}, PlaneMap()).quality, 0.0);
}

TEST(PlaneMap, FindsTheGroundLevelAndNoPlaneInACrown) {
  test::BoxWorld world;
  Scan scan = world.scan(0.0, 0.0, 0.0, 1);
  const std::size_t ground_points = scan.points.size();
  for (const Point& p : test::randomBlob({8.4, 8.4, 2.4}, {0.7, 0.7, 0.7}, 400, 3)) {
    scan.points.push_back(p);
  }
  const std::vector<PointRole> roles(scan.points.size(), PointRole::kObject);
  const PlaneMap planes(scan.points, roles);
  std::size_t found = 0;
  for (std::size_t i = 0; i < ground_points; i += 97) {
    const SmallPlane* plane = planes.planeOf(planes.voxelOf(scan.points[i].position()));
    if (plane == nullptr) continue;
    ++found;
    EXPECT_GT(std::abs(plane->normal.z()), 0.999F);
    EXPECT_NEAR(plane->mean.z(), -1.73F, 0.01F);
  }
  EXPECT_GT(found, 10U);
  EXPECT_EQ(planes.planeOf(planes.voxelOf({8.4F, 8.4F, 2.4F})), nullptr);
}

}  // namespace
}  // namespace segdf
