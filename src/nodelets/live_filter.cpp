// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/live_filter.hpp"

#include <sstream>
#include <utility>

#include "segdf/ros/parameters.hpp"
#include "segdf/segmentation/sensor_recognition.hpp"

namespace segdf {

LiveFilter::LiveFilter(const std::string& sensor, int threads, MakeConfig make_config, Tell tell)
    : threads_(threads), make_config_(std::move(make_config)), tell_(std::move(tell)) {
  if (sensor != NodeParameters::kAutoSensor) start(sensor);
}

bool LiveFilter::isBehind(const Scan& scan) const {
  return last_stamp_ns_ && scan.stamp_ns < *last_stamp_ns_;
}

std::vector<FrameResult> LiveFilter::process(Scan scan) {
  if (!pipeline_) start(recognise(scan));
  last_stamp_ns_ = scan.stamp_ns;
  return mapped(pipeline_->process(std::move(scan)));
}

std::vector<FrameResult> LiveFilter::flush() {
  return pipeline_ ? mapped(pipeline_->flush()) : std::vector<FrameResult>{};
}

void LiveFilter::restart() {
  last_stamp_ns_.reset();
  if (map_) map_->clear();
}

const std::vector<MapPoint>& LiveFilter::map() const {
  static const std::vector<MapPoint> no_points;
  return map_ ? map_->points() : no_points;
}

void LiveFilter::start(const std::string& sensor) {
  const Config config = make_config_(sensor);
  pipeline_.emplace(config, threads_);
  map_.emplace(config.map.live_voxel);
  max_misfit_ = config.input.max_misfit;
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
  for (const FrameResult& frame : frames) map_->add(frame);
  return frames;
}

}  // namespace segdf
