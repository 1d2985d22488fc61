// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/image_pieces.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

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
  /// @param columns of the image; the scan has 2048
  explicit Scene(int columns = 2048) {
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
    config.range_image.columns = columns;
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

/// Points that can be reached from each by links between neighbours of one cluster, itself
/// included; 0 for those of none.
std::vector<std::uint32_t> reachable(const Scene& scene, float jump) {
  const RangeImage& image = *scene.image;
  std::vector<std::vector<std::size_t>> links(scene.cluster.size());
  const auto link = [&](std::size_t i, std::int32_t other) {
    if (other == RangeImage::kNone) return;
    const auto j = static_cast<std::size_t>(other);
    const bool near = std::abs(image.rangeOf(i) - image.rangeOf(j)) < jump;
    if (scene.cluster[i] != scene.cluster[j] || !near) return;
    links[i].push_back(j);
    links[j].push_back(i);
  };
  std::vector<std::uint32_t> sizes(scene.cluster.size(), 0);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (scene.cluster[i] == Clusters::kNoise) continue;
    for (int right = -image.reach(); right <= image.reach(); ++right) {
      if (right >= 0) link(i, image.at(image.rowOf(i), image.columnOf(i) + right));
      link(i, image.at(image.rowOf(i) + 1, image.columnOf(i) + right));
    }
  }
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (scene.cluster[i] == Clusters::kNoise || sizes[i] != 0) continue;
    std::vector<std::size_t> piece{i};
    sizes[i] = 1;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      for (std::size_t j : links[piece[k]]) {
        if (sizes[j] == 0) piece.push_back(j);
        sizes[j] = 1;
      }
    }
    for (std::size_t j : piece) sizes[j] = static_cast<std::uint32_t>(piece.size());
  }
  return sizes;
}

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

/// @param columns of the image
void expectLinkedPieces(int columns) {
  const Scene scene(columns);
  const std::vector<std::uint32_t> sizes = reachable(scene, kFine);
  const ImagePieces pieces = scene.pieces(kFine, kCoarse);
  ASSERT_GT(pieces.largerThan(30).size(), 1U);
  for (std::size_t i = 0; i < sizes.size(); ++i) ASSERT_EQ(pieces.sizeAt(i), sizes[i]) << i;
}

TEST(ImagePieces, AreWhatLinksReach) { expectLinkedPieces(2048); }

TEST(ImagePieces, HoldThePointsBehindThoseThatTheImageShows) { expectLinkedPieces(900); }

TEST(ImagePieces, SpanTheEmptyColumnsOfAnImageThatIsFiner) { expectLinkedPieces(4096); }

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
