// SPDX-License-Identifier: BSD-3-Clause
// Makes a drive with exact labels, as a KITTI folder, a bag, or both.
#include <iostream>
#include <map>
#include <memory>
#include <string>

#include "segdf/io/kitti_writer.hpp"
#include "segdf/ros/bag_writer.hpp"
#include "segdf/simulation/scene_yaml.hpp"
#include "segdf/simulation/simulator.hpp"

#include "progress.hpp"
#include "run_app.hpp"

namespace {

struct Options {
  std::string output;
  std::string bag;
  bool list_scenes = false;
  segdf::SimulationConfig simulation;
};

const std::map<std::string, segdf::SimulatedIntensity> kIntensities{
    {"raw", segdf::SimulatedIntensity::kRaw}, {"kitti", segdf::SimulatedIntensity::kKitti}};

void addDisturbances(CLI::App& app, segdf::SimulationConfig& s) {
  app.add_option("--pose-noise", s.pose_noise, "sigma of each axis of the poses, m (default 0.02)")
      ->check(CLI::Range(0.0, 10.0));
  app.add_option("--pose-noise-angle", s.pose_noise_angle,
                 "sigma about each axis, deg (default 0.05)")
      ->check(CLI::Range(0.0, 45.0));
  app.add_option("--pose-drift", s.pose_drift, "error of the poses, percent of the way (default 0)")
      ->check(CLI::Range(0.0, 20.0));
  app.add_option("--intensity", s.intensity, "raw or kitti (default: the sensor's own)")
      ->transform(CLI::CheckedTransformer(kIntensities).description(""));
  app.add_flag("--skewed", s.skewed, "points as taken during the turn, with times (bag only)");
}

void addOptions(CLI::App& app, Options& options) {
  segdf::SimulationConfig& s = options.simulation;
  app.add_option("--output", options.output, "KITTI folder to write");
  app.add_option("--bag", options.bag, "bag to write");
  app.add_option("--scene", s.scene, "built-in scene or scene file (default mixed)");
  app.add_flag("--list-scenes", options.list_scenes, "names the built-in scenes and stops");
  app.add_option("--sensor", s.sensor, "hdl64, hdl32, vlp16 or os1_64 (default: the scene's)")
      ->check(CLI::IsMember({"hdl64", "hdl32", "vlp16", "os1_64"}));
  app.add_option("--seed", s.seed, "same seed, same bytes (default 1)");
  app.add_option("--scans", s.scans, "number of scans (default: the scene's duration)")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--rate", s.rate, "scans a second (default 10)")->check(CLI::Range(0.1, 100.0));
  app.add_option("--speed", s.speed, "of the ego vehicle, m/s (default: the scene's)")
      ->check(CLI::Range(0.1, 50.0));
  app.add_option("--threads", s.threads, "worker threads (default 1); same bytes with any")
      ->check(CLI::Range(1, 256));
  addDisturbances(app, s);
  app.callback([&options] {
    if (options.output.empty() && options.bag.empty() && !options.list_scenes) {
      throw CLI::RequiredError("--output DIR or --bag FILE");
    }
    if (options.simulation.skewed && !options.output.empty()) {
      throw CLI::ValidationError("--skewed", "KITTI folders hold no times of points; use --bag");
    }
  });
}

void listScenes() {
  for (const std::string& name : segdf::sceneNames()) {
    std::cout << name << "  " << segdf::sceneSummary(name) << '\n';
  }
}

void simulate(const Options& options) {
  segdf::Simulator simulator(options.simulation);
  std::unique_ptr<segdf::KittiWriter> folder;
  std::unique_ptr<segdf::BagWriter> bag;
  if (!options.output.empty()) folder = std::make_unique<segdf::KittiWriter>(options.output);
  if (!options.bag.empty()) {
    const bool skewed = options.simulation.skewed;
    bag = std::make_unique<segdf::BagWriter>(
        options.bag, skewed ? segdf::CloudForm::kSensor : segdf::CloudForm::kRegistered);
  }
  segdf::apps::Progress progress(simulator.scans());
  std::size_t done = 0;
  while (const auto simulated = simulator.next()) {
    if (folder) folder->add(simulated->scan, simulated->truth, simulated->exact_pose);
    if (bag) bag->add(simulated->scan, simulated->truth);
    progress.show(++done);
  }
  if (folder) folder->finish();
  if (bag) bag->finish();
  progress.finish();
  std::cout << done << " scans of " << simulator.sensor().name << " through "
            << options.simulation.scene << " in "
            << (options.output.empty() ? options.bag : options.output) << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Simulates a LiDAR drive through a scene, with exact labels.", "segdf_simulate");
  Options options;
  addOptions(app, options);
  return segdf::apps::runApp(app, argc, argv, [&options] {
    if (options.list_scenes) {
      listScenes();
    } else {
      simulate(options);
    }
    return static_cast<int>(segdf::apps::kOk);
  });
}
