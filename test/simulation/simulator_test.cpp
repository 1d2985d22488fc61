// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/simulator.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "segdf/core/semantic_kitti.hpp"

namespace segdf {
namespace {

std::vector<SimulatedScan> simulate(const SimulationConfig& config) {
  Simulator simulator(config);
  std::vector<SimulatedScan> scans;
  while (auto scan = simulator.next()) scans.push_back(std::move(*scan));
  return scans;
}

SimulationConfig quick(std::uint64_t seed, int threads = 1) {
  SimulationConfig config;
  config.sensor = "vlp16";
  config.scans = 6;
  config.rate = 2.0;
  config.seed = seed;
  config.threads = threads;
  return config;
}

bool samePoints(const SimulatedScan& a, const SimulatedScan& b) {
  if (a.truth != b.truth) return false;
  for (std::size_t i = 0; i < a.scan.points.size(); ++i) {
    if (a.scan.points[i].position() != b.scan.points[i].position() ||
        a.scan.points[i].intensity != b.scan.points[i].intensity) {
      return false;
    }
  }
  return true;
}

TEST(Simulator, TheSameSeedGivesTheSameDriveOnAnyNumberOfThreads) {
  const auto once = simulate(quick(3));
  for (int threads : {1, 2}) {
    const auto again = simulate(quick(3, threads));
    ASSERT_EQ(once.size(), again.size());
    for (std::size_t k = 0; k < once.size(); ++k) EXPECT_TRUE(samePoints(once[k], again[k]));
  }
}

TEST(Simulator, SkewedSweepsTakeTheirTimeAndAreDeterministicToo) {
  SimulationConfig config = quick(3);
  config.rate = 10.0;
  config.scans = 3;
  config.skewed = true;
  const auto once = simulate(config);
  config.threads = 2;
  const auto again = simulate(config);
  config.skewed = false;
  const auto straight = simulate(config);
  for (std::size_t k = 0; k < once.size(); ++k) {
    EXPECT_TRUE(samePoints(once[k], again[k]));
    EXPECT_FALSE(samePoints(once[k], straight[k]));
    float latest = 0.0F;
    for (const Point& p : once[k].scan.points) {
      latest = std::max(latest, p.time);
      // A turn takes a tenth of a second, from +x over the left.
      const float azimuth = std::atan2(p.y, p.x) + (p.y < 0.0F ? 6.2831853F : 0.0F);
      ASSERT_NEAR(p.time, 0.1F * azimuth / 6.2831853F, 1e-4F);
    }
    EXPECT_GT(latest, 0.099F);
  }
}

/// Over a turn the ego drives 0.8 m: half a turn later, a house is 0.4 m nearer.
TEST(Simulator, SkewIsThatOfTheWayDriven) {
  Scene scene;
  scene.ground.undulation = 0.0;
  SceneObject wall;
  Solid solid;
  solid.center = {0.0, 0.0, 5.0};
  solid.size = {1.0, 60.0, 10.0};
  wall.solids = {solid};
  wall.path = {{0.0, -20.5, 0.0, 0.0, 0.0}};
  wall.standing_class = 50;
  scene.objects = {wall};
  scene.ego = {{0.0, 0.0, 0.0, 0.0, 0.0}, {1.0, -8.0, 0.0, 0.0, 8.0}};
  SimulationConfig config;
  config.sensor = "vlp16";
  config.skewed = true;
  Simulator simulator(config, scene, 1);
  const auto scan = simulator.next();
  ASSERT_TRUE(scan);
  int behind = 0;
  for (const Point& p : scan->scan.points) {
    if (p.x > -15.0F || std::abs(p.y) > 0.3F || std::abs(p.z) > 1.0F) continue;
    EXPECT_NEAR(p.x, -19.6F, 0.12F) << "20 m less 0.4 m, within noise and bias";
    ++behind;
  }
  EXPECT_GT(behind, 3);
}

TEST(Simulator, AnotherSeedGivesAnotherDrive) {
  EXPECT_FALSE(samePoints(simulate(quick(3))[0], simulate(quick(4))[0]));
}

TEST(Simulator, EveryPointHasItsTruthAndRingsAreOrdered) {
  for (const SimulatedScan& s : simulate(quick(1))) {
    ASSERT_EQ(s.truth.size(), s.scan.points.size());
    EXPECT_GT(s.scan.points.size(), 10000U);
    for (std::size_t i = 0; i < s.truth.size(); ++i) {
      ASSERT_GT(semantic_kitti::classOf(s.truth[i]), 1U);
      ASSERT_GE(s.scan.points[i].ring, s.scan.points[i > 0 ? i - 1 : 0].ring);
    }
  }
}

/// Azimuth rises within each ring from +x, so that readers of KITTI files recover the rings.
TEST(Simulator, RingsStartAtTheXAxis) {
  const SimulatedScan s = simulate(quick(1))[0];
  std::map<std::int16_t, float> last;
  for (const Point& p : s.scan.points) {
    float azimuth = std::atan2(p.y, p.x);
    if (azimuth < 0.0F) azimuth += 6.2831853F;
    const auto before = last.find(p.ring);
    if (before != last.end()) {
      ASSERT_GT(azimuth, before->second);
    }
    last[p.ring] = azimuth;
  }
}

TEST(Simulator, WhatStandsStaysAndWhatMovesMoves) {
  struct Track {
    std::map<std::size_t, Eigen::Vector3d> mean;
  };
  std::map<std::uint32_t, Track> tracks;
  const auto scans = simulate(quick(2));
  for (std::size_t k = 0; k < scans.size(); ++k) {
    std::map<std::uint32_t, std::pair<Eigen::Vector3d, double>> sums;
    for (std::size_t i = 0; i < scans[k].truth.size(); ++i) {
      if (semantic_kitti::instanceOf(scans[k].truth[i]) == 0) continue;
      auto& sum = sums.try_emplace(scans[k].truth[i], Eigen::Vector3d::Zero(), 0.0).first->second;
      sum.first += scans[k].exact_pose * scans[k].scan.points[i].position().cast<double>();
      sum.second += 1.0;
    }
    for (const auto& [label, sum] : sums) {
      if (sum.second >= 30.0) tracks[label].mean[k] = sum.first / sum.second;
    }
  }
  int movers = 0;
  int parked = 0;
  for (const auto& [label, track] : tracks) {
    for (const auto& [k, mean] : track.mean) {
      const auto next = track.mean.find(k + 1);
      if (next == track.mean.end()) continue;
      const double moved = (next->second - mean).norm();
      if (semantic_kitti::isMoving(semantic_kitti::classOf(label))) {
        ++movers;
        EXPECT_GT(moved, 0.3) << label << ": half a second at walking pace";
      } else {
        ++parked;
        // Another part of the car comes into view, but the car is no longer than that.
        EXPECT_LT(moved, 2.5) << label;
      }
    }
  }
  EXPECT_GT(movers, 3);
  EXPECT_GT(parked, 3);
}

TEST(Simulator, MovingPointsAreAFewPercentAndOfAllKinds) {
  SimulationConfig config = quick(1);
  config.sensor = "os1_64";
  config.scans = 20;
  std::size_t moving = 0;
  std::size_t all = 0;
  std::set<std::uint16_t> classes;
  for (const SimulatedScan& s : simulate(config)) {
    for (std::uint32_t label : s.truth) {
      classes.insert(semantic_kitti::classOf(label));
      moving += semantic_kitti::isMoving(semantic_kitti::classOf(label)) ? 1 : 0;
      ++all;
    }
  }
  // method.md 8.5 asks for 5 to 15 % of the mixed drive; the default street must not be much
  // easier.
  EXPECT_GT(static_cast<double>(moving), 0.03 * static_cast<double>(all));
  EXPECT_LT(static_cast<double>(moving), 0.20 * static_cast<double>(all));
  for (int c : {10, 40, 48, 50, 70, 80, 252, 253, 254, 257}) {
    EXPECT_EQ(classes.count(static_cast<std::uint16_t>(c)), 1U) << "class " << c;
  }
}

TEST(Simulator, PoseNoiseIsInThePoseAndNotInTheExactPose) {
  SimulationConfig config = quick(1);
  config.pose_noise = 0.1;
  config.pose_noise_angle = 0.0;
  SimulationConfig exact = quick(1);
  exact.pose_noise = 0.0;
  exact.pose_noise_angle = 0.0;
  const auto clean = simulate(exact);
  const auto noisy = simulate(config);
  double sum = 0.0;
  for (std::size_t k = 0; k < clean.size(); ++k) {
    EXPECT_TRUE(noisy[k].exact_pose.isApprox(clean[k].scan.pose));
    sum += (noisy[k].scan.pose.translation() - noisy[k].exact_pose.translation()).squaredNorm();
  }
  // 18 draws of sigma 0.1: the root mean square lies within 0.04 of it (beyond 3 sigma otherwise).
  EXPECT_NEAR(std::sqrt(sum / (3.0 * static_cast<double>(clean.size()))), 0.1, 0.05);
}

TEST(Simulator, DriftGrowsWithTheWay) {
  SimulationConfig config = quick(1);
  config.pose_noise = 0.0;
  config.pose_noise_angle = 0.0;
  config.pose_drift = 1.0;
  const auto scans = simulate(config);
  const auto error = [&scans](std::size_t k) {
    return (scans[k].scan.pose.translation() - scans[k].exact_pose.translation()).norm();
  };
  EXPECT_NEAR(error(0), 0.0, 1e-9);
  // 2.5 s at 8 m/s are 20 m, of which 1 % across the ground and 0.3 % upwards.
  EXPECT_NEAR(error(5), 0.2, 0.03);
}

TEST(Simulator, ScenesSayWhatSensorAndWhatIsLost) {
  SimulationConfig config;
  config.scene = "s20_sparse";
  config.scans = 4;
  Simulator sparse(config);
  EXPECT_EQ(sparse.sensor().name, "vlp16");
  std::set<std::size_t> counts;
  while (const auto scan = sparse.next()) counts.insert(scan->scan.points.size() / 100);
  EXPECT_GT(counts.size(), 1U) << "dropouts change from scan to scan";
  config.sensor = "os1_64";
  EXPECT_EQ(Simulator(config).sensor().name, "os1_64");
  config.scene = "s99_nowhere";
  EXPECT_THROW(Simulator{config}, std::invalid_argument);
}

TEST(Simulator, RawIntensityFallsWithTheRange) {
  SimulationConfig config = quick(1);
  config.scans = 1;
  config.intensity = SimulatedIntensity::kRaw;
  double near = 0.0;
  double far = 0.0;
  std::size_t near_count = 0;
  std::size_t far_count = 0;
  const std::vector<SimulatedScan> scans = simulate(config);
  for (const Point& p : scans[0].scan.points) {
    const double range = p.position().cast<double>().norm();
    ASSERT_GE(p.intensity, 0.0F);
    ASSERT_LE(p.intensity, 1.0F);
    if (range < 10.0) near += static_cast<double>(p.intensity);
    near_count += range < 10.0 ? 1 : 0;
    if (range > 30.0) far += static_cast<double>(p.intensity);
    far_count += range > 30.0 ? 1 : 0;
  }
  // (10 / 30)^2 is a ninth.
  EXPECT_LT(far / static_cast<double>(far_count), 0.3 * near / static_cast<double>(near_count));
}

}  // namespace
}  // namespace segdf
