// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "segdf/core/quantile.hpp"
#include "segdf/ros/drive_check.hpp"
#include "segdf/ros/topics.hpp"

namespace segdf {
namespace {

constexpr double kSeconds = 1e-9;  // a nanosecond

// A gap is several scans long, and long enough for another car to come and go unseen.
constexpr double kGapScans = 3.0;
constexpr double kGapSeconds = 1.0;
constexpr double kSlowest = 1.0;      // scans a second; votes come from the scans within 5 s
constexpr std::size_t kFewest = 10;   // scans; with fewer, hardly anything is seen more than once
constexpr double kOtherClock = 60.0;  // seconds between stamp and receipt
constexpr double kRounding = 1e-3;    // seconds; what floats and microseconds cut off is far less
constexpr double kSteady = 0.1;       // spread of an offset that counts as constant
// Farther from its pose than half a second, a car is somewhere else.
constexpr std::array<double, 6> kSlops{0.01, 0.02, 0.05, 0.1, 0.2, 0.5};  // seconds
constexpr double kNearlyAll = 0.95;

/// For each cloud without pose, seconds from its stamp to that of the nearest pose.
std::vector<double> offsets(const BagSurvey& survey) {
  std::set<std::int64_t> stamps;
  for (const PoseRecord& pose : survey.poses) stamps.insert(pose.stamp_ns);
  std::vector<double> result;
  for (const CloudRecord& cloud : survey.clouds) {
    const auto after = stamps.lower_bound(cloud.stamp_ns);
    std::int64_t nearest = after == stamps.end() ? *stamps.rbegin() : *after;
    if (after != stamps.begin() &&
        cloud.stamp_ns - *std::prev(after) < std::abs(nearest - cloud.stamp_ns)) {
      nearest = *std::prev(after);
    }
    if (nearest != cloud.stamp_ns) {
      result.push_back(static_cast<double>(nearest - cloud.stamp_ns) * kSeconds);
    }
  }
  return result;
}

/// Clouds that the launch file pairs with this sync_slop: as Synchroniser, which waits for a later
/// pose.
std::size_t pairsWith(double slop, const std::vector<double>& offsets, const BagSurvey& survey) {
  std::int64_t last = 0;
  for (const PoseRecord& pose : survey.poses) last = std::max(last, pose.stamp_ns);
  const auto behind = std::count_if(survey.clouds.begin(), survey.clouds.end(),
                                    [last](auto& cloud) { return cloud.stamp_ns > last; });
  const auto near = std::count_if(offsets.begin(), offsets.end(),
                                  [slop](double offset) { return std::abs(offset) <= slop; });
  return survey.pairs.size() + static_cast<std::size_t>(std::max<std::ptrdiff_t>(near - behind, 0));
}

/// The least sync_slop with which nearly every cloud that can get a pose between two others does;
/// "" if it helps none.
std::string slopAdvice(const std::vector<double>& offsets, const BagSurvey& survey) {
  const std::size_t most = pairsWith(kSlops.back(), offsets, survey);
  if (most == survey.pairs.size()) return "";
  for (const double slop : kSlops) {
    const std::size_t pairs = pairsWith(slop, offsets, survey);
    if (static_cast<double>(pairs) < kNearlyAll * static_cast<double>(most)) continue;
    return "; live, sync_slop:=" + fixed(slop, 2) +
           " interpolates poses: " + std::to_string(pairs) + " of " +
           std::to_string(survey.clouds.size()) + " clouds then have one";
  }
  return "";
}

/// Why no pose may have the stamp of a cloud, and what helps.
std::string remedy(const std::vector<double>& sorted) {
  const double largest = std::max(std::abs(sorted.front()), std::abs(sorted.back()));
  const double spread = sorted.back() - sorted.front();
  if (largest < kRounding) return "stamps were rounded on the way (PCL keeps microseconds)";
  if (largest > kOtherClock) return "the two were stamped by different clocks";
  if (spread < kSteady * largest)
    return "a constant offset: one was stamped elsewhere in the sweep";
  return "the odometry runs at a rate of its own";
}

void reportNoPair(const BagSurvey& survey, BagReport& report) {
  std::vector<double> sorted = offsets(survey);
  std::sort(sorted.begin(), sorted.end());
  report.errors.push_back(
      "no pose on " + survey.topics.odometry + " has the stamp of a cloud on " +
      survey.topics.cloud + ": the nearest is " + fixed(medianOf(sorted), 6) + " s off (median; " +
      fixed(sorted.front(), 6) + " to " + fixed(sorted.back(), 6) + "), so " + remedy(sorted) +
      "; give each pose the stamp of its cloud, or name another topic with --odometry-topic" +
      slopAdvice(sorted, survey));
}

void reportUnpaired(const BagSurvey& survey, BagReport& report) {
  const std::size_t unpaired = survey.clouds.size() - survey.pairs.size();
  report.facts.emplace_back("pairs", std::to_string(survey.pairs.size()) + " of " +
                                         std::to_string(survey.clouds.size()) +
                                         " clouds have a pose of the same stamp");
  // LIO-SAM deskews every sweep, but maps only some of them: that is how it should be.
  if (unpaired == 0 || survey.topics.cloud == topics::kDeskewedCloud) return;
  std::size_t first = 0;
  while (first < survey.pairs.size() && survey.pairs[first].cloud == first) ++first;
  report.warnings.push_back(
      std::to_string(unpaired) + " clouds have no pose of the same stamp on " +
      survey.topics.odometry + " and are left out (the first is " + cloudAt(survey, first) +
      "); record both topics from start to end" + slopAdvice(offsets(survey), survey));
}

void reportDisorder(const BagSurvey& survey,
                    const std::vector<RecordPair>& accepted,
                    BagReport& report) {
  const std::size_t late = survey.pairs.size() - accepted.size();
  if (late == 0) return;
  std::size_t first = 0;
  while (first < accepted.size() && survey.pairs[first].cloud == accepted[first].cloud) ++first;
  const std::size_t cloud = survey.pairs[first].cloud;
  const bool twice = first > 0 && survey.clouds[cloud].stamp_ns ==
                                      survey.clouds[accepted[first - 1].cloud].stamp_ns;
  report.warnings.push_back(
      std::to_string(late) + " clouds are not later than one before and are left out (the first, " +
      cloudAt(survey, cloud) + (twice ? ", has the same stamp" : ", goes back in time") +
      "); if the bag holds several drives or a replay in a loop, cut it with 'rosbag filter'");
}

std::vector<double> intervals(const BagSurvey& survey, const std::vector<RecordPair>& pairs) {
  std::vector<double> result;
  for (std::size_t k = 1; k < pairs.size(); ++k) {
    result.push_back(static_cast<double>(survey.clouds[pairs[k].cloud].stamp_ns -
                                         survey.clouds[pairs[k - 1].cloud].stamp_ns) *
                     kSeconds);
  }
  return result;
}

void reportGaps(const BagSurvey& survey,
                const std::vector<RecordPair>& pairs,
                const std::vector<double>& steps,
                BagReport& report) {
  const double limit = std::max(kGapSeconds, kGapScans * medianOf(steps));
  const auto gaps = std::count_if(steps.begin(), steps.end(), [&](double s) { return s > limit; });
  if (gaps == 0) return;
  const auto longest = std::max_element(steps.begin(), steps.end());
  const std::size_t cloud = pairs[static_cast<std::size_t>(longest - steps.begin())].cloud;
  report.warnings.push_back(
      std::to_string(gaps) + " gaps of more than " + fixed(limit, 1) + " s between scans (" +
      fixed(*longest, 1) + " s after " + cloudAt(survey, cloud) +
      "): across a gap nobody saw what moved; record with a larger buffer, 'rosbag record -b 0'");
}

void reportRate(const BagSurvey& survey, const std::vector<RecordPair>& pairs, BagReport& report) {
  const std::vector<double> steps = intervals(survey, pairs);
  if (pairs.size() < kFewest) {
    report.warnings.push_back(
        "only " + std::to_string(pairs.size()) +
        " scans: what moved is seen by comparing scans of several seconds; record a longer drive");
  }
  if (steps.empty()) return;
  const double rate = 1.0 / medianOf(steps);
  const double duration = std::accumulate(steps.begin(), steps.end(), 0.0);
  report.facts.emplace_back("time", std::to_string(pairs.size()) + " scans in " +
                                        fixed(duration, 1) + " s, " + fixed(rate, 1) + " a second");
  if (rate < kSlowest) {
    report.warnings.push_back("only " + fixed(rate, 2) +
                              " scans a second: too few see the same place within 5 s; map at 2 a "
                              "second or more");
  }
  reportGaps(survey, pairs, steps, report);
}

void reportReceipt(const BagSurvey& survey, BagReport& report) {
  std::vector<double> delays;
  for (const CloudRecord& cloud : survey.clouds) {
    delays.push_back(static_cast<double>(cloud.received_ns - cloud.stamp_ns) * kSeconds);
  }
  const double delay = medianOf(delays);
  const bool other = std::abs(delay) > kOtherClock;
  report.facts.emplace_back("receipt",
                            fixed(delay, 3) + " s after the stamp (median)" +
                                (other ? ", by another clock; no harm: stamps count" : ""));
}

void reportZeroStamps(const BagSurvey& survey, BagReport& report) {
  const auto zeros = std::count_if(survey.clouds.begin(), survey.clouds.end(),
                                   [](const CloudRecord& cloud) { return cloud.stamp_ns == 0; });
  if (zeros == 0) return;
  report.errors.push_back(
      std::to_string(zeros) + " clouds on " + survey.topics.cloud +
      " have stamp 0, which is none; set header.stamp where they are published");
}

}  // namespace

void checkStamps(const BagSurvey& survey, BagReport& report) {
  reportZeroStamps(survey, report);
  if (survey.pairs.empty()) {
    reportNoPair(survey, report);
    return;
  }
  reportUnpaired(survey, report);
  const std::vector<RecordPair> accepted = inOrder(survey);
  reportDisorder(survey, accepted, report);
  reportRate(survey, accepted, report);
  reportReceipt(survey, report);
}

}  // namespace segdf
