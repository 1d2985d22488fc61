// SPDX-License-Identifier: BSD-3-Clause
#include "offline_runner.hpp"

#include <array>
#include <csignal>
#include <future>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <utility>
#include <vector>

#include "segdf/io/config_yaml.hpp"
#include "segdf/pipeline/pipeline.hpp"

#include "progress.hpp"
#include "run_app.hpp"
#include "segment_dump.hpp"

namespace segdf::apps {

namespace {

volatile std::sig_atomic_t stop_requested = 0;

void requestStop(int /*signal*/) { stop_requested = 1; }

std::string metres(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << value << " m";
  return text.str();
}

/// Statuses whose scans mean that the input is not what it should be.
constexpr std::array<FrameStatus, 3> kBadStatuses{FrameStatus::kEmpty, FrameStatus::kInvalidPose,
                                                  FrameStatus::kTimeBackwards};

}  // namespace

Config OfflineRunner::configure(const std::optional<Scan>& first) {
  DriveConfig chosen = configureDrive(options_.input, first);
  sensor_ = chosen.sensor;
  if (!options_.mode.empty()) {
    applyYaml(chosen.config, "df: {mode: " + options_.mode + "}", "--mode");
  }
  return chosen.config;
}

/// The next scan; when the input breaks off, the reason is kept for the end and the drive is over.
std::optional<Scan> OfflineRunner::nextScan(ScanSource& source) {
  if (stop_requested != 0) return std::nullopt;
  try {
    return source.next();
  } catch (const IoError& error) {
    break_off_ = error.what();
    return std::nullopt;
  }
}

void OfflineRunner::filter(ScanSource& source,
                           std::optional<Scan> scan,
                           const Config& config,
                           const std::function<void(const FrameResult&)>& take) {
  // With more than one thread the next scan is read and the last frames are written meanwhile.
  const auto when = options_.threads > 1 ? std::launch::async : std::launch::deferred;
  const auto take_all = [&take](const std::vector<FrameResult>& frames) {
    for (const FrameResult& frame : frames) take(frame);
  };
  Pipeline pipeline(config, options_.threads);
  Progress progress(source.size());
  std::future<void> taken = std::async(when, [] {});
  for (std::size_t done = 1; scan; ++done) {
    std::future<std::optional<Scan>> next = std::async(when, [&] { return nextScan(source); });
    std::vector<FrameResult> frames = pipeline.process(std::move(*scan));
    taken.get();
    taken = std::async(when, [&take_all, frames = std::move(frames)] { take_all(frames); });
    scan = next.get();
    progress.show(done);
  }
  taken.get();
  pipeline.flush(take);
  progress.finish();
}

int OfflineRunner::finish(DriveWriter& writer, const Config& config) {
  const RunReport& report = writer.report();
  int code = kOk;
  for (FrameStatus status : kBadStatuses) {
    if (report.count(status) == 0) continue;
    warn(std::to_string(report.count(status)) + " scans left out: " + toString(status) +
         " (the first is scan " + std::to_string(report.firstOf(status)) + ")");
    if (status != FrameStatus::kEmpty) code = kPartial;
  }
  if (report.jumps() > 0) {
    warn("the pose jumps " + std::to_string(report.jumps()) +
         " times by more than input.max_jump = " + metres(config.input.max_jump) +
         " (loop closure?); what lies before and after a jump is judged separately");
  }
  if (report.nonFinitePoints() > 0) {
    warn(std::to_string(report.nonFinitePoints()) +
         " points with NaN or infinite coordinates ignored");
  }
  if (report.medianMisfit() > config.input.max_misfit) {
    warn("poses do not fit the scans: consecutive scans disagree by " +
         metres(report.medianMisfit()) +
         " (median; more than input.max_misfit = " + metres(config.input.max_misfit) +
         "); check that poses belong to these scans and to the lidar, not to camera or base");
  }
  writer.finish();
  std::cout << report.summary() << "results in " << options_.output.string() << '\n';
  if (!break_off_.empty()) {
    std::cerr << "error: " << break_off_ << " (the " << report.frames()
              << " scans before it are saved)\n";
    return kPartial;
  }
  return stop_requested != 0 ? static_cast<int>(kStopped) : code;
}

int OfflineRunner::run() {
  std::signal(SIGINT, requestStop);
  std::signal(SIGTERM, requestStop);
  const std::unique_ptr<ScanSource> source = openDrive(options_.input);
  std::optional<Scan> first = nextScan(*source);
  if (!first && !break_off_.empty()) throw IoError(break_off_);
  if (!first) throw IoError("no scan in " + source->describe());
  const Config config = configure(first);
  std::optional<SegmentDump> dump;
  if (!options_.segments.empty()) dump.emplace(options_.segments);
  DriveWriter writer(options_.output, config);
  writer.report().setSetting({source->describe(), sensor_,
                              nameOf(config.df.mode, DynamicConfig::kModes), options_.threads});
  try {
    filter(*source, std::move(first), config, [&](const FrameResult& frame) {
      writer.add(frame);
      if (dump) dump->add(frame);
    });
    const int code = finish(writer, config);
    if (dump) dump->finish();
    return code;
  } catch (const IoError& error) {
    writer.abandon(error);
  }
}

}  // namespace segdf::apps
