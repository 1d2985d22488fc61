// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/ground_zones.hpp"

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "segdf/segmentation/arc_tangent.hpp"

namespace segdf {
namespace {

constexpr double kHeight = 1.8;

RangeImageConfig lasers(int beams, double lowest, double highest) {
  RangeImageConfig config;
  config.beams = beams;
  config.elevation_min = lowest;
  config.elevation_max = highest;
  return config;
}

const RangeImageConfig kVlp16 = lasers(16, -15.0, 15.0);
const RangeImageConfig kHdl32 = lasers(32, -30.67, 10.67);
const RangeImageConfig kHdl64 = lasers(64, -24.8, 2.7);

/// Where the laser meets level ground ahead, metres.
double landing(const RangeImageConfig& sensor, int laser) {
  const double step = (sensor.elevation_max - sensor.elevation_min) / (sensor.beams - 1);
  const double down = -(sensor.elevation_min + laser * step) * 3.14159265358979323846 / 180.0;
  return down > 0.0 ? kHeight / std::tan(down) : -1.0;
}

Point ahead(double range) { return {static_cast<float>(range), 0.0F, 0.0F, 0.0F, 0.0F, -1}; }

int patchOf(const ConcentricZones& zones, const Point& p) {
  return zones.patchOf(p, turnOf(static_cast<double>(p.y), static_cast<double>(p.x)));
}

TEST(GroundZones, SixtyFourLasersHaveTheZonesOfPatchwork) {
  const ConcentricZones zones(GroundConfig{}, kHdl64, kHeight);
  EXPECT_EQ(zones.patches(), 2 * 16 + 4 * 32 + 4 * 54 + 4 * 32);
  // l_min 2.7 and l_max 80: zones end at 12.36, 22.03, 41.35 and 80 m.
  EXPECT_EQ(patchOf(zones, ahead(2.6)), -1);
  EXPECT_EQ(zones.ringOf(patchOf(zones, ahead(12.3))), 1);
  EXPECT_EQ(zones.ringOf(patchOf(zones, ahead(12.4))), 2);
  EXPECT_EQ(zones.ringOf(patchOf(zones, ahead(41.3))), 9);
  EXPECT_EQ(zones.ringOf(patchOf(zones, ahead(79.9))), 13);
  EXPECT_EQ(patchOf(zones, ahead(80.1)), -1);
}

TEST(GroundZones, WithFewLasersARingHoldsTwoOrIsWide) {
  GroundConfig config;
  config.l_min = 1.0;
  for (const RangeImageConfig& sensor : {kVlp16, kHdl32}) {
    std::map<int, std::vector<double>> rings;  // by patch ahead: where its lasers meet the ground
    for (int laser = 0; laser < sensor.beams; ++laser) {
      const double range = landing(sensor, laser);
      if (range < 0.0 || range > config.l_max) continue;
      rings[patchOf(ConcentricZones(config, sensor, kHeight), ahead(range))].push_back(range);
      // Noise in range does not take a laser's line into another ring.
      EXPECT_EQ(patchOf(ConcentricZones(config, sensor, kHeight), ahead(0.98 * range)),
                patchOf(ConcentricZones(config, sensor, kHeight), ahead(1.02 * range)));
    }
    EXPECT_GE(rings.size(), 3U);
    for (const auto& [patch, ranges] : rings) {
      if (ranges.front() < 20.0) {  // nearer, no two lasers of these are 15 m apart
        EXPECT_GE(ranges.size(), 2U) << sensor.beams << " lasers, " << ranges.front() << " m";
      }
    }
  }
}

TEST(GroundZones, TyingCanBeLeftOut) {
  GroundConfig config;
  config.tie_beams = 0;
  EXPECT_EQ(ConcentricZones(config, kVlp16, kHeight).patches(),
            ConcentricZones(config, kHdl64, kHeight).patches());
}

TEST(GroundZones, TheInnerNeighbourIsOnTheWayToTheSensor) {
  for (const RangeImageConfig& sensor : {kVlp16, kHdl32, kHdl64}) {
    const ConcentricZones zones(GroundConfig{}, sensor, kHeight);
    int patch = patchOf(zones, ahead(70.0));
    int rings = 0;
    for (; patch >= 0; patch = zones.innerNeighbour(patch)) {
      bool is_ahead = false;
      for (double range = 2.8; range < 80.0; range += 0.1) {
        // The sector that begins at azimuth 0, or its neighbour when sectors do not match.
        const Point left{
            static_cast<float>(range), static_cast<float>(0.09 * range), 0.0F, 0.0F, 0.0F, -1};
        is_ahead =
            is_ahead || patchOf(zones, ahead(range)) == patch || patchOf(zones, left) == patch;
      }
      EXPECT_TRUE(is_ahead) << patch;
      ++rings;
    }
    EXPECT_GE(rings, 4);
  }
}

TEST(GroundZones, TheSideNeighboursGoOnceAroundTheRing) {
  const ConcentricZones zones(GroundConfig{}, RangeImageConfig{}, kHeight);
  const std::vector<std::pair<double, int>> sectors{{5.0, 16}, {15.0, 32}, {30.0, 54}, {70.0, 32}};
  for (const auto& [range, count] : sectors) {
    const int start = patchOf(zones, ahead(range));
    const auto x = static_cast<float>(range);
    EXPECT_EQ(zones.sideNeighbour(start, -1),
              patchOf(zones, {x, -0.05F * x, 0.0F, 0.0F, 0.0F, -1}));
    int patch = start;
    for (int k = 1; k < count; ++k) {
      const int last = patch;
      patch = zones.sideNeighbour(patch, 1);
      EXPECT_NE(patch, start) << range;
      EXPECT_EQ(zones.sideNeighbour(patch, -1), last);
    }
    EXPECT_EQ(zones.sideNeighbour(patch, 1), start);
  }
}

}  // namespace
}  // namespace segdf
