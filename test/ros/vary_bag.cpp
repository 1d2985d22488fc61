// SPDX-License-Identifier: BSD-3-Clause
// Writes a bag's drive again as another bag, for the tests of the nodelet: vary_bag KIND IN OUT.
//   sensor  the clouds in the sensor's frame (LIO-SAM's other form)
//   jump    the second half moved by 3 m, as by a loop closure
//   mount   clouds of a sensor on a roof, poses of the base below, the way between them in
//   /tf_static
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <tf2_eigen/tf2_eigen.h>

#include <rosbag/bag.h>
#include <tf2_msgs/TFMessage.h>

#include "segdf/ros/bag_source.hpp"
#include "segdf/ros/bag_writer.hpp"
#include "segdf/ros/lio_sam_messages.hpp"
#include "segdf/ros/topics.hpp"

namespace {

using segdf::Scan;

constexpr double kJump = 3.0;  // metres

void rewrite(segdf::BagSource& in, const std::string& out, segdf::CloudForm form, double jump) {
  segdf::BagWriter writer(out, form, true);
  const std::size_t scans = in.size();
  std::size_t k = 0;
  while (std::optional<Scan> scan = in.next()) {
    if (2 * k++ >= scans) scan->pose.translation().y() += jump;
    writer.add(*scan, std::vector<std::uint32_t>(scan->points.size(), 0));
  }
  writer.finish();
}

/// 1.7 m up and 1 m forward, turned a quarter to the left.
segdf::Pose mounting() {
  return Eigen::Translation3d(1.0, 0.0, 1.7) *
         Eigen::AngleAxisd(0.5 * 3.14159265358979, Eigen::Vector3d::UnitZ());
}

tf2_msgs::TFMessage staticTransform(const ros::Time& stamp) {
  tf2_msgs::TFMessage message;
  message.transforms.push_back(tf2::eigenToTransform(mounting()));
  message.transforms[0].header.frame_id = "base_link";
  message.transforms[0].header.stamp = stamp;
  message.transforms[0].child_frame_id = "velodyne";
  return message;
}

void writeMounted(segdf::BagSource& in, const std::string& out) {
  rosbag::Bag bag(out, rosbag::bagmode::Write);
  bool first = true;
  while (std::optional<Scan> scan = in.next()) {
    sensor_msgs::PointCloud2 cloud = segdf::toSensorCloud(*scan);
    cloud.header.frame_id = "velodyne";
    scan->pose = scan->pose * mounting().inverse();
    nav_msgs::Odometry odometry = segdf::toOdometry(*scan);
    odometry.child_frame_id = "base_link";
    const ros::Time stamp = cloud.header.stamp;
    if (first) bag.write("/tf_static", stamp, staticTransform(stamp));
    first = false;
    bag.write("/points", stamp, cloud);
    bag.write("/odometry", stamp, odometry);
    const std::vector<std::uint32_t> truth(scan->points.size(), 0);
    bag.write(segdf::topics::kTruthLabels, stamp, segdf::toTruthCloud(*scan, truth));
  }
  bag.close();
}

void vary(const std::string& kind, segdf::BagSource& in, const std::string& out) {
  if (kind == "sensor") return rewrite(in, out, segdf::CloudForm::kSensor, 0.0);
  if (kind == "jump") return rewrite(in, out, segdf::CloudForm::kRegistered, kJump);
  if (kind == "mount") return writeMounted(in, out);
  throw std::invalid_argument("no kind of bag: " + kind);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 4) throw std::invalid_argument("usage: vary_bag KIND IN OUT");
    segdf::BagSource in(argv[2]);
    vary(argv[1], in, argv[3]);
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
}
