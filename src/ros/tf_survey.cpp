// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/tf_survey.hpp"

#include <map>
#include <set>
#include <vector>

#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>

#include "segdf/ros/bag_access.hpp"
#include "segdf/ros/topics.hpp"

namespace segdf {
namespace {

/// Who is whose parent, and who moves against it.
struct FrameTree {
  std::map<std::string, std::string> parent;
  std::set<std::string> moving;  ///< children on /tf
};

FrameTree readTree(const rosbag::Bag& bag) {
  FrameTree tree;
  rosbag::View view(bag,
                    rosbag::TopicQuery(std::vector<std::string>{topics::kTf, topics::kTfStatic}));
  for (const rosbag::MessageInstance& instance : view) {
    const auto message = readMessage<tf2_msgs::TFMessage>(instance);
    for (const auto& transform : message->transforms) {
      tree.parent[transform.child_frame_id] = transform.header.frame_id;
      if (instance.getTopic() == topics::kTf) tree.moving.insert(transform.child_frame_id);
    }
  }
  return tree;
}

std::string frameOfClouds(const rosbag::Bag& bag, const std::string& topic) {
  rosbag::View view(bag, rosbag::TopicQuery(topic));
  if (view.size() == 0) return "";
  return readMessage<sensor_msgs::PointCloud2>(*view.begin())->header.frame_id;
}

/// The frame above all others, "" if nothing moves on the way there.
std::string rootAbove(const FrameTree& tree, const std::string& frame) {
  std::string at = frame;
  bool moves = false;
  std::set<std::string> seen;  // a loop has no root
  for (auto link = tree.parent.find(at); link != tree.parent.end(); link = tree.parent.find(at)) {
    if (!seen.insert(at).second) return "";
    moves = moves || tree.moving.count(at) != 0;
    at = link->second;
  }
  return moves ? at : "";
}

}  // namespace

std::string tfArguments(const rosbag::Bag& bag, const std::string& cloud_topic) {
  const FrameTree tree = readTree(bag);
  const std::string cloud = frameOfClouds(bag, cloud_topic);
  const std::string root = rootAbove(tree, cloud);
  if (!root.empty()) return "use_tf:=true map_frame:=" + root;
  const bool registered = tree.parent.count(cloud) == 0 && tree.moving.size() == 1 &&
                          rootAbove(tree, *tree.moving.begin()) == cloud;
  if (!registered) return "";
  return "use_tf:=true map_frame:=" + cloud + " sensor_frame:=" + *tree.moving.begin();
}

}  // namespace segdf
