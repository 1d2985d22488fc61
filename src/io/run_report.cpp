// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/run_report.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include <sys/resource.h>

#include "segdf/core/quantile.hpp"
#include "segdf/io/atomic_file.hpp"

#include <nlohmann/json.hpp>

namespace segdf {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<FrameStatus, 5> kStatuses{FrameStatus::kMapped, FrameStatus::kNotKeyFrame,
                                               FrameStatus::kEmpty, FrameStatus::kInvalidPose,
                                               FrameStatus::kTimeBackwards};
constexpr std::array<PointState, 5> kStates{PointState::kUnjudged, PointState::kGround,
                                            PointState::kStatic, PointState::kDynamic,
                                            PointState::kNoise};

struct Usage {
  double cpu_seconds = 0.0;
  double peak_mib = 0.0;
};

/// CPU time and peak memory of this process so far.
Usage usage() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return {seconds(used.ru_utime) + seconds(used.ru_stime),
          static_cast<double>(used.ru_maxrss) / 1024.0};
}

/// JSON has no NaN.
Json numberOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(); }

}  // namespace

void RunReport::add(const FrameResult& frame) {
  const auto status = static_cast<std::size_t>(frame.status);
  if (by_status_[status]++ == 0) first_of_status_[status] = frame.index;
  ++frames_;
  for (const PointLabel& label : frame.labels) ++by_state_[static_cast<std::size_t>(label.state)];
  jumps_ += frame.after_jump ? 1 : 0;
  non_finite_points_ += frame.non_finite_points;
  if (std::isfinite(frame.pose_misfit)) misfits_.push_back(frame.pose_misfit);
  times_.ground += frame.times.ground;
  times_.normals += frame.times.normals;
  times_.clustering += frame.times.clustering;
  times_.classification += frame.times.classification;
  times_.dynamics += frame.times.dynamics;
}

void RunReport::revoke(const Revocation& revocation) {
  by_state_[static_cast<std::size_t>(PointState::kStatic)] -= revocation.points;
  by_state_[static_cast<std::size_t>(PointState::kDynamic)] += revocation.points;
}

double RunReport::medianMisfit() const { return medianOf(misfits_); }

void RunReport::setInstances(std::size_t instances, std::size_t removed) {
  instances_ = instances;
  removed_instances_ = removed;
}

double RunReport::wallSeconds() const { return watch_.seconds(); }

void RunReport::write(const std::filesystem::path& file) const {
  const Usage used = usage();
  Json json;
  json["source"] = setting_.source;
  json["sensor"] = setting_.sensor;
  json["mode"] = setting_.mode;
  json["threads"] = setting_.threads;
  for (FrameStatus status : kStatuses) json["scans"][toString(status)] = count(status);
  for (PointState state : kStates) {
    json["points"][toString(state)] = by_state_[static_cast<std::size_t>(state)];
  }
  json["pose_jumps"] = jumps_;
  json["points_not_finite"] = non_finite_points_;
  json["instances"] = instances_;
  json["instances_dynamic"] = removed_instances_;
  json["pose_misfit_median_m"] = numberOrNull(medianMisfit());
  json["stage_seconds"] = {{"ground", times_.ground},
                           {"normals", times_.normals},
                           {"clustering", times_.clustering},
                           {"classification", times_.classification},
                           {"dynamics", times_.dynamics}};
  json["wall_seconds"] = wallSeconds();
  json["cpu_seconds"] = used.cpu_seconds;
  json["peak_memory_mib"] = used.peak_mib;
  AtomicFile out(file);
  out.write(json.dump(2) + "\n");
  out.commit();
}

std::string RunReport::summary() const {
  const Usage used = usage();
  const double scans = std::max<double>(1.0, static_cast<double>(frames_));
  const double wall = wallSeconds();
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << mapped() << " of " << frames_ << " scans mapped, "
       << by_state_[static_cast<std::size_t>(PointState::kDynamic)] << " points removed, "
       << removed_instances_ << " of " << instances_ << " instances dynamic\n"
       << wall << " s wall (" << wall / scans << " s a scan), " << used.cpu_seconds << " s CPU, "
       << std::setprecision(0) << used.peak_mib << " MiB peak memory\n"
       << std::setprecision(1) << "ms a scan: ground " << 1e3 * times_.ground / scans
       << ", normals " << 1e3 * times_.normals / scans << ", clustering "
       << 1e3 * times_.clustering / scans << ", classification "
       << 1e3 * times_.classification / scans << ", dynamics " << 1e3 * times_.dynamics / scans
       << "\n";
  return text.str();
}

}  // namespace segdf
