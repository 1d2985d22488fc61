// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/image_pieces.hpp"

#include <optional>

#include <gtest/gtest.h>

#include "segdf/segmentation/clustering.hpp"
#include "segdf/segmentation/segmenter.hpp"

#include "support/box_world.hpp"

namespace segdf {
namespace {

constexpr float kFine = 0.06F;
constexpr float kCoarse = 0.1F;
/// Number of the cluster that a test parts from the others.
constexpr std::int32_t kNew = 100;

/// Cars, a wall seen at a flat angle and a person in front of it.
struct Scene {
  Scene() {
    test::BoxWorld world;
    world.add(10.0, 0.0, 0.2, 0.5, 1.7);
    world.add(10.4, 0.0, 0.3, 8.0, 2.6);
    world.add(20.0, 6.0, 30.0, 0.3, 2.6);
    world.add(8.0, -6.0, 4.2, 1.8, 0.9);
    world.add(7.8, -6.0, 2.0, 1.6, 1.5);
    scan = world.scan(0.0, 0.0, 0.0, 0, 2048);
    Config config;
    config.person.jump = 0.0;
    config.bicycle.jump = 0.0;
    StageTimes times;
    const Segmentation seg = segmentScan(scan, config, 1, times);
    cluster = clusterOfPoints(scan.points.size(), seg.voxels, seg.clusters);
    image.emplace(scan.points, seg.roles, config.range_image);
  }

  ImagePieces pieces(float jump, float next_jump) const {
    return {*image, cluster, jump, next_jump};
  }

  Scan scan;
  std::vector<std::int32_t> cluster;
  std::optional<RangeImage> image;
};

void expectSame(const ImagePieces& a, const ImagePieces& b, std::size_t points) {
  for (std::size_t i = 0; i < points; ++i) ASSERT_EQ(a.sizeAt(i), b.sizeAt(i)) << i;
  const auto of_a = a.largerThan(1);
  const auto of_b = b.largerThan(1);
  ASSERT_EQ(of_a.size(), of_b.size());
  for (std::size_t k = 0; k < of_a.size(); ++k) {
    EXPECT_EQ(of_a[k].cluster, of_b[k].cluster);
    EXPECT_EQ(of_a[k].points, of_b[k].points);
  }
}

TEST(ImagePieces, TheNextOnesAreAsIfSoughtAnew) {
  const Scene scene;
  ImagePieces pieces = scene.pieces(kFine, kCoarse);
  const std::size_t fine = pieces.largerThan(1).size();
  pieces.proceed(scene.cluster);
  ASSERT_LT(pieces.largerThan(1).size(), fine) << "no link but the finer ones";
  expectSame(pieces, scene.pieces(kCoarse, kCoarse), scene.cluster.size());
}

TEST(ImagePieces, TheNextOnesMayBeFiner) {
  const Scene scene;
  ImagePieces pieces = scene.pieces(kCoarse, kFine);
  pieces.proceed(scene.cluster);
  expectSame(pieces, scene.pieces(kFine, kFine), scene.cluster.size());
}

TEST(ImagePieces, TheNextOnesRespectNewBordersOfClusters) {
  Scene scene;
  ImagePieces pieces = scene.pieces(kFine, kCoarse);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < scene.cluster.size(); ++i) {
    const Point& p = scene.scan.points[i];
    if (scene.cluster[i] == Clusters::kNoise || p.y < 0.1F || p.y > 2.0F) continue;
    scene.cluster[i] = kNew;
    ++changed;
  }
  ASSERT_GT(changed, 100U);
  pieces.proceed(scene.cluster);
  expectSame(pieces, scene.pieces(kCoarse, kCoarse), scene.cluster.size());
}

}  // namespace
}  // namespace segdf
