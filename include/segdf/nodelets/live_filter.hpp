// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/core/frame_result.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/mapping/instance_table.hpp"
#include "segdf/mapping/static_map.hpp"
#include "segdf/pipeline/pipeline.hpp"

namespace segdf {

/// Map and instances at one moment.
struct MapSnapshot {
  std::vector<MapPoint> points;
  std::vector<InstanceRecord> instances;  ///< ordered by id
};

/// The pipeline as the nodelet drives it: with the sensor recognised on the first scan, and a map
/// that can be shown at any time. Knows messages as little as the pipeline does. For one thread,
/// but for snapshot().
class LiveFilter {
 public:
  /// Gives the configuration for a sensor, with the user's own parameters on top.
  using MakeConfig = std::function<Config(const std::string& sensor)>;
  /// Gets one line for the user.
  using Tell = std::function<void(const std::string&)>;

  /// @param sensor name in cfg/sensors, or "auto"
  /// @param threads of the pipeline, at least 1
  /// @throws what `make_config` and the pipeline throw for wrong parameters
  LiveFilter(const std::string& sensor, int threads, MakeConfig make_config, Tell tell);

  /// True iff time has gone backwards by a second or more (rosbag play --loop): flush() and
  /// restart() come first. By less, it is a scan out of order, which the pipeline turns away.
  bool isBehind(const Scan& scan) const;

  /// The frames that leave the window, already in the map.
  std::vector<FrameResult> process(Scan scan);

  /// The frames that are still in the window, already in the map.
  std::vector<FrameResult> flush();

  /// Forgets time, map and instances. The sensor stays.
  void restart();

  /// True iff the frame's pose does not fit its scan: input.max_misfit is exceeded.
  bool isMisfit(const FrameResult& frame) const;

  /// Empty before the first frame.
  const std::vector<MapPoint>& map() const;

  /// A copy, from any thread, while frames are being processed.
  MapSnapshot snapshot() const;

  /// In force; nothing before the first scan where the sensor is recognised by it.
  const std::optional<Config>& config() const { return config_; }
  /// Name of the sensor in force, "" likewise.
  const std::string& sensor() const { return sensor_; }

 private:
  void start(const std::string& sensor);
  std::string recognise(const Scan& scan) const;
  std::vector<FrameResult> mapped(std::vector<FrameResult> frames);

  int threads_;
  MakeConfig make_config_;
  Tell tell_;
  std::string sensor_;
  std::optional<Config> config_;
  std::optional<Pipeline> pipeline_;
  mutable std::mutex map_mutex_;  ///< held to change map and instances, and to copy them
  std::optional<StaticMap> map_;
  InstanceTable instances_;
  std::optional<std::int64_t> last_stamp_ns_;
};

}  // namespace segdf
