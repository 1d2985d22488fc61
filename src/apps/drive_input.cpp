// SPDX-License-Identifier: BSD-3-Clause
#include "drive_input.hpp"

#include <iomanip>
#include <iostream>
#include <sstream>

#include "segdf/io/config_yaml.hpp"
#include "segdf/io/frame_range.hpp"
#include "segdf/io/kitti_source.hpp"
#include "segdf/ros/bag_source.hpp"
#include "segdf/segmentation/sensor_recognition.hpp"

namespace segdf::apps {

namespace {

std::unique_ptr<ScanSource> openBag(const DriveInput& input) {
  auto bag =
      std::make_unique<BagSource>(input.bag, BagTopics{input.cloud_topic, input.odometry_topic});
  if (bag->unmatched() > 0) {
    warn(std::to_string(bag->unmatched()) + " clouds on " + bag->topics().cloud +
         " have no pose of the same stamp on " + bag->topics().odometry + " and are left out");
  }
  return bag;
}

std::string recognise(const std::optional<Scan>& first) {
  const SensorGuess guess = recogniseSensor(first.value_or(Scan{}));
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "sensor " << guess.name << " (" << guess.beams
       << " lasers from " << guess.elevation_min << " to " << guess.elevation_max << " deg)";
  if (guess.certain) {
    std::cerr << "recognised " << text.str() << '\n';
  } else {
    warn("unknown sensor; the nearest is taken: " + text.str() + "; set --sensor or --config");
  }
  return guess.name;
}

}  // namespace

void warn(const std::string& message) { std::cerr << "warning: " << message << '\n'; }

void addDriveOptions(CLI::App& app, DriveInput& input) {
  auto* drive = app.add_option_group("input");
  drive->add_option("--bag", input.bag, "ROS 1 bag with clouds and odometry");
  drive->add_option("--kitti", input.kitti,
                    "folder with velodyne/, poses.txt and calib.txt or "
                    "poses_lidar.txt");
  drive->require_option(0, 1);
  app.add_option("--sensor", input.sensor,
                 "hdl64, hdl32, vlp16 or os1_64; recognised if not given");
  app.add_option("--config", input.config, "YAML with parameters that differ from the sensor's");
  app.add_option("--frames", input.frames,
                 "only these scans of the folder, FIRST:LAST:STEP, ends inclusive");
  app.add_option("--rate", input.rate, "scans a second of a folder without times.txt (default 10)")
      ->check(CLI::PositiveNumber);
  app.add_option("--cloud-topic", input.cloud_topic,
                 "default: LIO-SAM's registered, else deskewed");
  app.add_option("--odometry-topic", input.odometry_topic, "default: LIO-SAM's mapping odometry");
}

void checkDriveOptions(const DriveInput& input) {
  if (input.bag.empty() && input.kitti.empty()) {
    throw CLI::RequiredError("--bag FILE or --kitti DIR");
  }
  if (!input.frames.empty() && input.kitti.empty()) {
    throw CLI::RequiresError("--frames", "--kitti DIR");
  }
}

std::unique_ptr<ScanSource> openDrive(const DriveInput& input) {
  if (!input.bag.empty()) return openBag(input);
  const FrameRange frames = input.frames.empty() ? FrameRange{} : parseFrameRange(input.frames);
  auto folder = std::make_unique<KittiSource>(input.kitti, input.rate, frames);
  if (folder->timesAssumed()) {
    warn("no times.txt in " + input.kitti.string() + ": " + formatNumber(input.rate) +
         " scans a second assumed; set --rate if that is wrong");
  }
  return folder;
}

DriveConfig configureDrive(const DriveInput& input, const std::optional<Scan>& first) {
  const std::string sensor = input.sensor.empty() ? recognise(first) : input.sensor;
  Config config = sensorConfig(sensor);
  if (!input.config.empty()) applyYamlFile(config, input.config);
  return {sensor, config};
}

}  // namespace segdf::apps
