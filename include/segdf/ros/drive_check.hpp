// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "segdf/ros/bag_report.hpp"
#include "segdf/ros/bag_survey.hpp"

/// Checks of a drive that need no point. Each adds what it finds to the report.
namespace segdf {

/// Stamps: identical for cloud and pose? in order? gaps, rate, time of receipt.
void checkStamps(const BagSurvey& survey, BagReport& report);

/// Frames, and in which of LIO-SAM's forms the clouds are.
void checkFrames(const BagSurvey& survey, BagReport& report);

/// Poses: valid? way, jumps such as loop closures make.
void checkPoses(const BagSurvey& survey, BagReport& report);

/// True if clouds and poses share their frame: the clouds are in the odometry frame.
/// @pre the survey has a pair
bool isRegistered(const BagSurvey& survey);

}  // namespace segdf
