// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/core/frame_result.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/mapping/static_map.hpp"
#include "segdf/pipeline/pipeline.hpp"

namespace segdf {

/// The pipeline as the nodelet drives it: with the sensor recognised on the first scan, and a map
/// that can be shown at any time. Knows messages as little as the pipeline does. Not thread-safe.
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

  /// True iff time has gone backwards (rosbag play --loop): flush() and restart() come first.
  bool isBehind(const Scan& scan) const;

  /// The frames that leave the window, already in the map.
  std::vector<FrameResult> process(Scan scan);

  /// The frames that are still in the window, already in the map.
  std::vector<FrameResult> flush();

  /// Forgets time and map. The sensor stays.
  void restart();

  /// True iff the frame's pose does not fit its scan: input.max_misfit is exceeded.
  bool isMisfit(const FrameResult& frame) const { return frame.pose_misfit > max_misfit_; }

  /// Empty before the first frame.
  const std::vector<MapPoint>& map() const;

 private:
  void start(const std::string& sensor);
  std::string recognise(const Scan& scan) const;
  std::vector<FrameResult> mapped(std::vector<FrameResult> frames);

  int threads_;
  MakeConfig make_config_;
  Tell tell_;
  double max_misfit_ = 0.0;
  std::optional<Pipeline> pipeline_;
  std::optional<StaticMap> map_;
  std::optional<std::int64_t> last_stamp_ns_;
};

}  // namespace segdf
