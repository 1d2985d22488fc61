// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/live_filter.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include "segdf/ros/parameters.hpp"
#include "segdf/segmentation/sensor_recognition.hpp"

namespace segdf {
namespace {

constexpr std::int64_t kStepBackNs = 1'000'000'000;

}  // namespace

LiveFilter::LiveFilter(const std::string& sensor, int threads, MakeConfig make_config, Tell tell)
    : threads_(threads), make_config_(std::move(make_config)), tell_(std::move(tell)) {
  if (sensor != NodeParameters::kAutoSensor) start(sensor);
}

bool LiveFilter::isBehind(const Scan& scan) const {
  return last_stamp_ns_ && scan.stamp_ns <= *last_stamp_ns_ - kStepBackNs;
}

std::vector<FrameResult> LiveFilter::process(Scan scan) {
  if (!pipeline_) start(recognise(scan));
  last_stamp_ns_ = std::max(last_stamp_ns_.value_or(scan.stamp_ns), scan.stamp_ns);
  return mapped(pipeline_->process(std::move(scan)));
}

std::vector<FrameResult> LiveFilter::flush() {
  std::vector<FrameResult> frames;
  if (pipeline_) {
    pipeline_->flush([&frames](FrameResult frame) { frames.push_back(std::move(frame)); });
  }
  return mapped(std::move(frames));
}

void LiveFilter::restart() {
  last_stamp_ns_.reset();
  const std::lock_guard<std::mutex> lock(map_mutex_);
  if (map_) map_->clear();
  instances_ = InstanceTable();
}

bool LiveFilter::isMisfit(const FrameResult& frame) const {
  return config_ && frame.pose_misfit > config_->input.max_misfit;
}

const std::vector<MapPoint>& LiveFilter::map() const {
  static const std::vector<MapPoint> no_points;
  return map_ ? map_->points() : no_points;
}

MapSnapshot LiveFilter::snapshot() const {
  const std::lock_guard<std::mutex> lock(map_mutex_);
  return {map(), instances_.records()};
}

void LiveFilter::start(const std::string& sensor) {
  const Config config = make_config_(sensor);
  pipeline_.emplace(config, threads_);
  config_ = config;
  sensor_ = sensor;
  const std::lock_guard<std::mutex> lock(map_mutex_);
  map_.emplace(config.map.live_voxel);
}

std::string LiveFilter::recognise(const Scan& scan) const {
  const SensorGuess guess = recogniseSensor(scan);
  std::ostringstream line;
  line << "sensor " << (guess.certain ? "recognised as " : "not known, nearest is ") << guess.name
       << " (" << guess.beams << " lasers from " << guess.elevation_min << " to "
       << guess.elevation_max << " degrees); the parameter 'sensor' sets another";
  tell_(line.str());
  return guess.name;
}

std::vector<FrameResult> LiveFilter::mapped(std::vector<FrameResult> frames) {
  const std::lock_guard<std::mutex> lock(map_mutex_);
  for (const FrameResult& frame : frames) {
    for (const Revocation& revocation : frame.revoked) {
      map_->revoke(revocation);
      instances_.revoke(revocation);
    }
    map_->add(frame);
    instances_.add(frame);
  }
  return frames;
}

}  // namespace segdf
