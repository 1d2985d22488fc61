// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <visualization_msgs/MarkerArray.h>

#include <segdf/DisplayConfig.h>

#include "segdf/core/frame_result.hpp"

namespace segdf {

/// A box (namespace "box/<class>") and a text with id and class ("text/<class>") for each instance
/// of the frame, in the map frame: red if dynamic, green if static. A mover that was followed gets
/// an arrow ("motion/<class>") as long as its way in one second. The namespaces let rviz hide a
/// class. The first marker deletes those of the frame before.
/// @param display box_opacity and text_size (metres); at 0 there are no boxes or no texts
visualization_msgs::MarkerArray toMarkers(const FrameResult& frame,
                                          const std::string& frame_id,
                                          const DisplayConfig& display);

}  // namespace segdf
