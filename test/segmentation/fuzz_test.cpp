// SPDX-License-Identifier: BSD-3-Clause
// Scans that no sensor makes: nothing may crash, hang, or lose a point.
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "segdf/classification/classifier.hpp"
#include "segdf/classification/features.hpp"
#include "segdf/segmentation/segmenter.hpp"

namespace segdf {
namespace {

class Generator {
 public:
  explicit Generator(std::uint32_t seed) : engine_(seed) {}

  float uniform(float low, float high) {
    const auto share = static_cast<float>(engine_()) / static_cast<float>(std::mt19937::max());
    return low + (high - low) * share;
  }
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine_()) % n; }

 private:
  std::mt19937 engine_;
};

using MakePoint = std::function<Point(Generator&)>;

Scan scanOf(std::size_t count, std::uint32_t seed, const MakePoint& make) {
  Generator generator(seed);
  Scan scan;
  for (std::size_t i = 0; i < count; ++i) scan.points.push_back(make(generator));
  return scan;
}

/// Segments, describes and classifies; every point must come out in one place, every feature
/// finite.
void check(const Scan& scan, const std::string& what) {
  SCOPED_TRACE(what);
  const Config config;
  StageTimes times;
  Segmentation seg = segmentScan(scan, config, 2, times);
  ASSERT_EQ(seg.roles.size(), scan.points.size());
  std::vector<int> places(scan.points.size(), 0);
  for (std::size_t v = 0; v < seg.voxels.size(); ++v) {
    for (std::uint32_t k = seg.voxels.begin[v]; k < seg.voxels.begin[v + 1]; ++k) {
      ++places[seg.voxels.points[k]];
    }
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    ASSERT_EQ(places[i], seg.roles[i] == PointRole::kObject ? 1 : 0);
    ASSERT_TRUE(seg.roles[i] == PointRole::kUnused || std::isfinite(seg.height[i]));
  }
  const PointAttributes attributes{scan.points, seg.height, seg.row, seg.column, seg.surfaces};
  for (Segment& segment : seg.segments) {
    describeSegment(attributes, segment);
    for (float value : segment.features.values) ASSERT_TRUE(std::isfinite(value));
    classify(segment.features, segment.points.size(), config.classes);
  }
}

Point inBox(Generator& g, float half) {
  return {g.uniform(-half, half),
          g.uniform(-half, half),
          g.uniform(-half, half),
          g.uniform(-1.0F, 2.0F),
          0.0F,
          -1};
}

TEST(Fuzz, RandomClouds) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    for (float half : {1e-30F, 1e-3F, 2.0F, 30.0F, 119.0F, 1e6F, 1e30F}) {
      check(scanOf(20000, seed, [half](Generator& g) { return inBox(g, half); }),
            "half side " + std::to_string(half));
    }
  }
}

TEST(Fuzz, AnyRingOrNone) {
  check(scanOf(20000, 4,
               [](Generator& g) {
                 Point p = inBox(g, 40.0F);
                 p.ring = static_cast<std::int16_t>(g.below(65536));
                 return p;
               }),
        "rings over the whole range of the type");
}

TEST(Fuzz, DegenerateShapes) {
  check({}, "nothing");
  check(scanOf(1, 1, [](Generator&) { return Point{5, 0, 0, 0.1F, 0, -1}; }), "one point");
  check(scanOf(3000, 1, [](Generator&) { return Point{5, 1, 0.5F, 0.1F, 0, 3}; }), "coincident");
  check(scanOf(3000, 5,
               [](Generator& g) {
                 const float t = g.uniform(-50.0F, 50.0F);
                 return Point{t, 2 * t, 0.1F * t, 0.1F, 0, -1};
               }),
        "collinear");
  check(scanOf(3000, 6,
               [](Generator& g) {
                 return Point{g.uniform(-50, 50), g.uniform(-50, 50), -1.7F, 0.1F, 0, 3};
               }),
        "a plane in one ring");
  check(scanOf(3000, 7, [](Generator& g) { return Point{0, 0, g.uniform(-50, 50), 0.1F, 0, -1}; }),
        "the vertical axis");
}

TEST(Fuzz, NotFiniteAmongGoodPoints) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  check(scanOf(20000, 8,
               [](Generator& g) {
                 Point p = inBox(g, 30.0F);
                 switch (g.below(6)) {
                   case 0:
                     p.x = kNan;
                     break;
                   case 1:
                     p.y = kInf;
                     break;
                   case 2:
                     p.z = -kInf;
                     break;
                   case 3:
                     p.intensity = kNan;
                     break;
                   case 4:
                     p.intensity = kInf;
                     break;
                   default:
                     break;
                 }
                 return p;
               }),
        "NaN and infinity");
}

TEST(Fuzz, TwoMillionPoints) {
  check(scanOf(2000000, 9,
               [](Generator& g) {
                 const float turn = g.uniform(0.0F, 6.2832F);
                 const float range = g.uniform(2.0F, 100.0F);
                 return Point{range * std::cos(turn),
                              range * std::sin(turn),
                              g.uniform(-1.8F, 3.0F),
                              g.uniform(0.0F, 1.0F),
                              0.0F,
                              static_cast<std::int16_t>(g.below(128))};
               }),
        "two million points");
}

}  // namespace
}  // namespace segdf
