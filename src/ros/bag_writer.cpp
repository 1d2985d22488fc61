// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/bag_writer.hpp"

#include <limits>
#include <string>

#include <tf2_msgs/TFMessage.h>

#include "segdf/io/scan_source.hpp"
#include "segdf/ros/lio_sam_messages.hpp"
#include "segdf/ros/topics.hpp"

namespace segdf {
namespace {

// Receipt times follow the stamps as in a live recording, odometry first (layout.md 3).
constexpr double kOdometryDelay = 0.001;  // seconds
constexpr double kCloudDelay = 0.002;
constexpr double kTruthDelay = 0.003;

constexpr std::int64_t kNsPerSecond = 1'000'000'000;

// ros::Time counts seconds in 32 bits; one is left for the delays.
constexpr std::int64_t kLastStampNs =
    std::int64_t{std::numeric_limits<std::uint32_t>::max() - 1} * kNsPerSecond;

void checkStamp(std::int64_t stamp_ns) {
  if (stamp_ns > 0 && stamp_ns < kLastStampNs) return;
  throw IoError(
      "stamp of " + std::to_string(stamp_ns) +
      " ns cannot be a ROS time (above 0 s, below 2^32 s): correct the times of the drive");
}

void checkTruth(std::size_t points, std::size_t labels) {
  if (labels == 0 || labels == points) return;
  throw IoError("scan of " + std::to_string(points) + " points has " + std::to_string(labels) +
                " labels: give one for each point, or none");
}

const std::filesystem::path& unlessThere(const std::filesystem::path& file, bool overwrite) {
  if (overwrite || !std::filesystem::exists(file)) return file;
  throw IoError("bag '" + file.string() + "' exists: name another one, or give --force");
}

/// rosbag's exceptions as one line for the user.
template <class Action>
void orIoError(const Action& action) {
  try {
    action();
  } catch (const rosbag::BagException& error) {
    throw IoError(std::string("cannot write bag (") + error.what() + "): check the free space");
  }
}

}  // namespace

BagWriter::BagWriter(const std::filesystem::path& file, CloudForm form, bool overwrite)
    : file_(unlessThere(file, overwrite)), form_(form), bag_(std::make_unique<rosbag::Bag>()) {
  orIoError([this] { bag_->open(file_.temporaryPath().string(), rosbag::bagmode::Write); });
}

BagWriter::~BagWriter() {
  try {
    close();
  } catch (const IoError&) {
    // The disk is full, most likely. The unfinished file goes away all the same.
  }
}

void BagWriter::add(const Scan& scan, const std::vector<std::uint32_t>& truth) {
  checkTruth(scan.points.size(), truth.size());
  if (first_ && scan.stamp_ns == 0) offset_ns_ = kEpochNs;
  first_ = false;
  Scan moved = scan;
  moved.stamp_ns += offset_ns_;
  checkStamp(moved.stamp_ns);
  orIoError([&] { write(moved, truth); });
}

void BagWriter::write(const Scan& scan, const std::vector<std::uint32_t>& truth) {
  const nav_msgs::Odometry odometry = toOdometry(scan);
  const ros::Time stamp = odometry.header.stamp;
  tf2_msgs::TFMessage tf;
  tf.transforms.push_back(toTransform(scan));
  const auto after = [stamp](double delay) { return stamp + ros::Duration(delay); };
  bag_->write(topics::kTf, after(kOdometryDelay), tf);
  bag_->write(topics::kOdometry, after(kOdometryDelay), odometry);
  if (form_ == CloudForm::kRegistered) {
    bag_->write(topics::kRegisteredCloud, after(kCloudDelay), toRegisteredCloud(scan));
  } else {
    bag_->write(topics::kDeskewedCloud, after(kCloudDelay), toSensorCloud(scan));
  }
  if (!truth.empty()) {
    bag_->write(topics::kTruthLabels, after(kTruthDelay), toTruthCloud(scan, truth));
  }
}

void BagWriter::close() {
  // A bag that cannot be closed tries again in its destructor, where nobody can catch the
  // exception: it is given up instead.
  rosbag::Bag* bag = bag_.release();
  if (bag == nullptr) return;
  orIoError([bag] { bag->close(); });
  bag_.reset(bag);
}

void BagWriter::finish() {
  close();
  file_.commit();
}

}  // namespace segdf
