// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/clustering.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "support/box_world.hpp"

namespace segdf {
namespace {

using test::randomBlob;

struct Outcome {
  CurvedVoxels voxels;
  Clusters clusters;
  std::vector<std::int32_t> of_point;
};

Outcome cluster(const std::vector<Point>& points, const CurvedVoxelConfig& config) {
  const CurvedGrid grid(config, 1.0);
  std::vector<KeyedPoint> items;
  std::vector<float> intensity;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    items.emplace_back(*grid.keyOf(points[i].position().cast<double>()), i);
    intensity.push_back(points[i].intensity);
  }
  Outcome outcome;
  outcome.voxels = buildCurvedVoxels(items, intensity);
  outcome.clusters = clusterVoxels(points, intensity, outcome.voxels, grid, config);
  outcome.of_point.assign(points.size(), Clusters::kNoise);
  for (std::size_t v = 0; v < outcome.voxels.size(); ++v) {
    for (std::uint32_t k = outcome.voxels.begin[v]; k < outcome.voxels.begin[v + 1]; ++k) {
      outcome.of_point[outcome.voxels.points[k]] = outcome.clusters.of_voxel[v];
    }
  }
  return outcome;
}

std::vector<Point> joined(std::vector<Point> a, const std::vector<Point>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

void paint(std::vector<Point>& points, float intensity) {
  for (Point& p : points) p.intensity = intensity;
}

/// At 10 m a cell is 0.20 m deep and 0.07 m wide: blobs 0.5 m apart in range are more than two
/// cells apart, blobs 0.35 m apart are out of reach of stage 1 (gaps up to 0.2 m close) but within
/// ext = 2 of stage 2.
constexpr double kBlob = 0.6;

std::vector<Point> blobAt(double x, std::uint32_t seed) {
  return randomBlob({x, 0.0, 0.0}, {kBlob, kBlob, kBlob}, 3000, seed);
}

TEST(Clustering, ObjectsFarApartAreTwo) {
  const Outcome outcome = cluster(joined(blobAt(10.0, 1), blobAt(12.0, 2)), {});
  EXPECT_EQ(outcome.clusters.count, 2U);
  EXPECT_EQ(outcome.of_point.front(), 0);
  EXPECT_EQ(outcome.of_point.back(), 1);
}

TEST(Clustering, TouchingObjectsAreOne) {
  EXPECT_EQ(cluster(joined(blobAt(10.0, 1), blobAt(10.0 + kBlob, 2)), {}).clusters.count, 1U);
}

TEST(Clustering, AcrossTheSeamOfTheAzimuth) {
  const auto points = randomBlob({-10.0, 0.0, 0.0}, {0.5, 1.0, 0.5}, 3000, 3);
  EXPECT_EQ(cluster(points, {}).clusters.count, 1U);
  const auto ahead = randomBlob({10.0, 0.0, 0.0}, {0.5, 1.0, 0.5}, 3000, 3);  // azimuth 0 and 360
  EXPECT_EQ(cluster(ahead, {}).clusters.count, 1U);
}

TEST(Clustering, IntensityMergesWhatLiesWithinReachAndLooksAlike) {
  const double gap = 0.35;
  std::vector<Point> a = blobAt(10.0, 1);
  std::vector<Point> b = blobAt(10.0 + kBlob + gap, 2);
  EXPECT_EQ(cluster(joined(a, b), {}).clusters.count, 1U);
  paint(b, 0.8F);
  EXPECT_EQ(cluster(joined(a, b), {}).clusters.count, 2U) << "threAV = 0.25 must keep them apart";
}

TEST(Clustering, MergingStopsAtTheSizeOfOneMovableObject) {
  // The first blob's corners reach 10.49 m, cell 47; the second begins at 10.90 m and more,
  // cell 49.
  const double gap = 0.60;
  const auto a = randomBlob({10.0, 0.0, 0.0}, {kBlob, 4.0, kBlob}, 20000, 1);
  const auto b = randomBlob({10.0 + kBlob + gap, 1.4, 0.0}, {kBlob, 4.0, kBlob}, 20000, 2);
  EXPECT_EQ(cluster(joined(a, b), {}).clusters.count, 1U) << "5.4 x 1.8 m is a car";
  const auto far = randomBlob({10.0 + kBlob + gap, 2.6, 0.0}, {kBlob, 4.0, kBlob}, 20000, 2);
  EXPECT_EQ(cluster(joined(a, far), {}).clusters.count, 2U) << "6.6 m exceeds merge_long_side";
}

TEST(Clustering, AFewPointsAloneAreNoise) {
  const Outcome outcome =
      cluster(joined(blobAt(10.0, 1), randomBlob({20, 5, 0}, {.1, .1, .1}, 9, 4)), {});
  EXPECT_EQ(outcome.clusters.count, 1U);
  EXPECT_EQ(outcome.of_point.back(), Clusters::kNoise);
}

TEST(Clustering, GatesCutWhereIntensityChanges) {
  // Two neighbouring voxels of twelve points each.
  std::vector<Point> a = randomBlob({10.1, 0.02, 0.05}, {0.01, 0.01, 0.01}, 12, 1);
  std::vector<Point> b = randomBlob({10.3, 0.02, 0.05}, {0.01, 0.01, 0.01}, 12, 2);
  paint(b, 0.9F);
  CurvedVoxelConfig config;
  EXPECT_EQ(cluster(joined(a, b), config).clusters.count, 1U);
  for (IntensityGate gate : {IntensityGate::kEvidence, IntensityGate::kLiteral}) {
    config.gate = gate;
    EXPECT_EQ(cluster(joined(a, b), config).clusters.count, 2U);
  }
}

TEST(Clustering, OnlyTheLiteralGateCutsWithoutEvidence) {
  // Two points say nothing of a voxel's intensity: `evidence` keeps the link, the printed condition
  // cuts it.
  std::vector<Point> a = randomBlob({10.1, 0.02, 0.05}, {0.01, 0.01, 0.01}, 12, 1);
  std::vector<Point> b = randomBlob({10.3, 0.02, 0.05}, {0.01, 0.01, 0.01}, 2, 2);
  paint(b, 0.9F);
  CurvedVoxelConfig config;
  config.gate = IntensityGate::kEvidence;
  EXPECT_EQ(cluster(joined(a, b), config).of_point.back(), 0);
  config.gate = IntensityGate::kLiteral;
  EXPECT_EQ(cluster(joined(a, b), config).of_point.back(), Clusters::kNoise);
}

/// method.md 6.11: the partition does not depend on the order of points.
TEST(Clustering, OrderOfPointsDoesNotMatter) {
  const Scan scan = test::makeStreet().scan(0.0, 0.0, 0.0, 0);
  std::vector<Point> points;
  for (const Point& p : scan.points) {
    if (p.z > -1.5F) points.push_back(p);
  }
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::mt19937 generator(9);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[generator() % i]);
  std::vector<Point> shuffled;
  for (std::size_t i : order) shuffled.push_back(points[i]);

  const Outcome straight = cluster(points, {});
  const Outcome mixed = cluster(shuffled, {});
  ASSERT_EQ(straight.clusters.count, mixed.clusters.count);
  ASSERT_GT(straight.clusters.count, 5U);
  std::vector<std::int32_t> renamed(straight.clusters.count, -1);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::int32_t a = straight.of_point[order[i]];
    const std::int32_t b = mixed.of_point[i];
    ASSERT_EQ(a < 0, b < 0);
    if (a < 0) continue;
    if (renamed[static_cast<std::size_t>(a)] < 0) renamed[static_cast<std::size_t>(a)] = b;
    ASSERT_EQ(renamed[static_cast<std::size_t>(a)], b);
  }
}

TEST(Clustering, NumbersFollowTheSmallestPointIndex) {
  const Outcome outcome = cluster(joined(blobAt(20.0, 1), blobAt(8.0, 2)), {});
  EXPECT_EQ(outcome.of_point.front(), 0);
  EXPECT_EQ(outcome.of_point.back(), 1);
}

TEST(Clustering, NothingGivesNothing) { EXPECT_EQ(cluster({}, {}).clusters.count, 0U); }

}  // namespace
}  // namespace segdf
