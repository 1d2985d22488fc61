// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/intake.hpp"

#include <sstream>
#include <utility>

#include <ros/console.h>

#include "segdf/ros/topic_choice.hpp"

namespace segdf {
namespace {

constexpr double kTick = 1.0;         // seconds between two looks
constexpr int kSilentTicks = 5;       // until silence is told
constexpr int kOrphanTicks = 2;       // until clouds without publisher are the end
constexpr double kPoll = 0.02;        // seconds
constexpr std::size_t kHalves = 100;  // messages that may wait for their other half
// The ROS thread only pairs messages, so that nothing piles up here; were this queue bounded,
// roscpp would drop messages without a word. The one that is bounded is the worker's, and counts.
constexpr std::uint32_t kUnbounded = 0;

}  // namespace

Intake::Intake(ros::NodeHandle node,
               const NodeParameters& parameters,
               std::string name,
               Ledger& ledger,
               Handlers handlers,
               const tf2_ros::Buffer* buffer)
    : parameters_(parameters),
      name_(std::move(name)),
      ledger_(ledger),
      handlers_(std::move(handlers)),
      brake_(node, parameters.player, static_cast<std::size_t>(parameters.queue_size)) {
  const auto on_pair = [this](const auto& cloud, const auto& odometry) { hand(cloud, odometry); };
  if (parameters.use_tf) {
    tf_poses_ = std::make_unique<TfPoses>(*buffer, parameters.map_frame, parameters.sensor_frame,
                                          kHalves, on_pair);
  } else {
    synchroniser_ = std::make_unique<Synchroniser>(kHalves, parameters.sync_slop, on_pair);
    odometry_subscriber_ = node.subscribe("odometry", kUnbounded, &Intake::addOdometry, this);
  }
  cloud_subscriber_ = node.subscribe("cloud", kUnbounded, &Intake::addCloud, this);
  poll_timer_ =
      node.createWallTimer(ros::WallDuration(kPoll), [this](const auto& /*event*/) { poll(); });
  watch_timer_ =
      node.createWallTimer(ros::WallDuration(kTick), [this](const auto& /*event*/) { watch(); });
}

void Intake::addCloud(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  countGap(cloud->header);
  last_cloud_ = cloud->header;
  queue().addCloud(cloud);
  book();
}

void Intake::addOdometry(const nav_msgs::OdometryConstPtr& odometry) {
  last_pose_ = odometry->header;
  synchroniser_->addOdometry(odometry);
  book();
}

CloudQueue& Intake::queue() {
  if (tf_poses_) return *tf_poses_;
  return *synchroniser_;
}

void Intake::hand(const sensor_msgs::PointCloud2ConstPtr& cloud,
                  const nav_msgs::OdometryConstPtr& odometry) {
  ended_ = false;
  book();
  if (!handlers_.on_pair(cloud, odometry)) {
    ledger_.change([](Counts& counts) { ++counts.dropped; });
  }
  brake_.look(ledger_.counts().scansWaiting());
}

/// Publishers number their messages; simulated bags and some drivers do not.
void Intake::countGap(const std_msgs::Header& header) {
  if (!last_cloud_ || last_cloud_->seq == 0 || header.stamp <= last_cloud_->stamp) return;
  if (header.seq <= last_cloud_->seq + 1) return;
  const std::size_t gap = header.seq - last_cloud_->seq - 1;
  ledger_.change([gap](Counts& counts) { counts.lost += gap; });
}

void Intake::book() {
  const CloudQueue::Counts& halves = queue().counts();
  const std::size_t waiting = queue().waiting();
  ledger_.change([&](Counts& counts) {
    counts.clouds = halves.clouds;
    counts.poses = halves.poses;
    counts.pairs = halves.pairs;
    counts.unmatched = halves.unmatched;
    counts.clouds_waiting = waiting;
  });
}

void Intake::poll() {
  if (tf_poses_) {
    tf_poses_->pairUp();
    book();
  }
  brake_.look(ledger_.counts().scansWaiting());
}

void Intake::watch() {
  watchForSilence();
  watchForLosses();
  watchForTheEnd();
  seen_ = ledger_.counts();
}

void Intake::watchForSilence() {
  const Counts counts = ledger_.counts();
  const bool silent = counts.pairs == seen_.pairs && counts.scansWaiting() == 0;  // not held
  silent_ticks_ = silent ? silent_ticks_ + 1 : 0;
  if (silent_ticks_ != kSilentTicks) return;
  if (counts.pairs == 0) {
    warnOfNoPair(counts);
  } else if (!ended_) {
    ROS_INFO_NAMED(name_, "no new scan for %.0f s, %zu so far; ~flush decides the last ones",
                   kSilentTicks * kTick, counts.pairs);
  }
}

std::string Intake::expectation(const Counts& counts) const {
  std::ostringstream text;
  text << "clouds (" << topics::kCloudType << ") on '" << cloud_subscriber_.getTopic()
       << "': " << counts.clouds << " came; ";
  if (tf_poses_) {
    text << "tf from '" << parameters_.map_frame << "' to '"
         << (parameters_.sensor_frame.empty() ? "the cloud's frame" : parameters_.sensor_frame)
         << "'";
  } else {
    text << "poses (" << topics::kOdometryType << ") on '" << odometry_subscriber_.getTopic()
         << "': " << counts.poses << " came";
  }
  return text.str();
}

void Intake::warnOfNoPair(const Counts& counts) const {
  std::ostringstream line;
  line << "no cloud with a pose for " << kSilentTicks * kTick
       << " s. Expected: " << expectation(counts) << ". ";
  if (last_cloud_ && last_pose_) {
    line << "Both come, but no stamps agree: the last are " << last_cloud_->stamp << " and "
         << last_pose_->stamp << "; sync_slop allows for a difference";
  } else {
    const TopicTypes on_air = topicsOnAir();
    line << "On the air: clouds on " << topicsOfType(on_air, topics::kCloudType) << "; poses on "
         << topicsOfType(on_air, topics::kOdometryType)
         << ". Set cloud_topic and odometry_topic of the launch file";
  }
  ROS_WARN_STREAM_NAMED(name_, line.str());
}

void Intake::watchForLosses() {
  const Counts counts = ledger_.counts();
  if (counts.unmatched > seen_.unmatched) {
    ROS_WARN_NAMED(name_, "%zu of %zu clouds had no pose at their stamp and were left out",
                   counts.unmatched, counts.clouds);
  }
  if (counts.dropped > seen_.dropped) {
    ROS_WARN_NAMED(name_,
                   "%zu of %zu scans were dropped because %d were waiting: play the bag slower, "
                   "give more threads, or raise queue_size",
                   counts.dropped, counts.pairs, parameters_.queue_size);
  }
  if (counts.lost > seen_.lost) {
    ROS_WARN_NAMED(name_,
                   "%zu clouds never came, by the gaps in header.seq: lost when the bag was "
                   "recorded, or on the way",
                   counts.lost);
  }
}

void Intake::watchForTheEnd() {
  orphan_ticks_ = cloud_subscriber_.getNumPublishers() == 0 ? orphan_ticks_ + 1 : 0;
  if (ended_ || orphan_ticks_ < kOrphanTicks) return;
  warnOfTheTail();
  ended_ = handlers_.on_end();
}

/// A player that ends drops what it has not sent: of the large clouds more than of the small poses.
void Intake::warnOfTheTail() const {
  if (!synchroniser_ || !last_cloud_) return;
  const std::size_t alone = synchroniser_->posesAfter(last_cloud_->stamp);
  const Counts counts = ledger_.counts();
  if (alone * counts.clouds <= counts.poses) return;  // no more than come with one cloud
  ROS_WARN_NAMED(name_,
                 "%zu poses are later than the last cloud: rosbag play ends without sending all it "
                 "has read. Play slower",
                 alone);
}

}  // namespace segdf
