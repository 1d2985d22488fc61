// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "segdf/classification/classifier.hpp"

namespace segdf {

namespace {
constexpr double kFoundAgain = 0.5;      // share of the points
constexpr float kCameSeconds = 5.0F;     // after 3 s edges of dark cars seemed to have come
constexpr std::size_t kCamePoints = 30;  // the edge of a dark car that returns nothing has fewer
constexpr float kSeenEmpty = 0.98F;      // share of the points that were looked at
constexpr double kLookedAt = 0.5;        // share of all points
}  // namespace

Verdict judgeVotes(const std::vector<PairVote>& votes,
                   ObjectClass object_class,
                   const DynamicConfig& config) {
  Verdict verdict;
  std::uint32_t far = 0;
  double best_far = 0.0;
  bool left = false;
  for (const PairVote& vote : votes) {
    if (!vote.informative) continue;
    left = left || vote.departure;
    const auto share = static_cast<double>(vote.freeShare());
    ++verdict.pairs;
    verdict.dynamic_votes += isSeenThrough(vote, config) ? 1 : 0;
    verdict.static_votes += share <= config.f_stat ? 1 : 0;
    verdict.best = std::max(verdict.best, vote.freeShare());
    if (!isFarInTime(static_cast<double>(vote.seconds), config)) continue;
    ++far;
    best_far = std::max(best_far, share);
  }
  const auto least = static_cast<std::uint32_t>(config.votes);
  verdict.needed =
      std::max(least, static_cast<std::uint32_t>(std::ceil(config.vote_share * verdict.pairs)));
  if (!isTested(object_class))
    verdict.needed = std::max(verdict.needed, (verdict.static_votes + 1) / 2);
  verdict.dynamic = verdict.dynamic_votes >= verdict.needed;
  if (verdict.pairs > 0) verdict.reason = Reason::kVotes;
  if (!verdict.dynamic && left) {
    verdict.dynamic = true;
    verdict.reason = Reason::kDeparture;
  }
  if (!verdict.dynamic && far < least && best_far >= config.f_single) {
    verdict.needed = 1;
    verdict.dynamic = true;
    verdict.reason = Reason::kLongLook;
  }
  return verdict;
}

bool isSeenThrough(const PairVote& vote, const DynamicConfig& config) {
  return vote.informative && static_cast<double>(vote.freeShare()) >= config.f_dyn;
}

bool isFoundAgain(const PairVote& vote, std::size_t points, const DynamicConfig& config) {
  return std::abs(static_cast<double>(vote.seconds)) >= kParkedSeconds &&
         static_cast<double>(vote.freeShare()) <= config.f_stat &&
         static_cast<double>(vote.hit) >= kFoundAgain * static_cast<double>(points);
}

bool cameHere(const std::vector<PairVote>& votes, std::size_t points, const DynamicConfig& config) {
  if (points < kCamePoints) return false;
  float empty = -std::numeric_limits<float>::infinity();
  for (const PairVote& vote : votes) {
    const double seen = static_cast<double>(vote.free) + static_cast<double>(vote.hit);
    const bool clear = vote.informative && vote.freeShare() >= kSeenEmpty &&
                       seen >= kLookedAt * static_cast<double>(points);
    if (clear && vote.seconds <= -kCameSeconds) empty = std::max(empty, vote.seconds);
  }
  return std::isfinite(empty) &&
         std::none_of(votes.begin(), votes.end(), [&](const PairVote& vote) {
           return vote.seconds < empty && isFoundAgain(vote, points, config);
         });
}

bool isParked(const std::vector<PairVote>& votes, std::size_t points, const DynamicConfig& config) {
  const auto found = std::count_if(votes.begin(), votes.end(), [&](const PairVote& vote) {
    return isFoundAgain(vote, points, config);
  });
  return found >= config.keep_hits;
}

}  // namespace segdf
