// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/dynamics/evidence.hpp"

namespace segdf {

/// Multi-frame decision on one segment (method.md 6.6).
struct Verdict {
  bool dynamic = false;
  std::uint32_t pairs = 0;          ///< informative ones
  std::uint32_t needed = 0;         ///< dynamic votes that were asked
  std::uint32_t dynamic_votes = 0;  ///< HD: F >= df.f_dyn
  std::uint32_t static_votes = 0;   ///< HS: F <= df.f_stat
  float best = 0.0F;                ///< largest F
  Reason reason = Reason::kNoEvidence;
};

/// Dynamic iff at least max(df.votes, df.vote_share of the informative pairs) have F >= df.f_dyn;
/// of what by its class cannot move, half as many as found it again besides: edges of crowns and of
/// walls are seen through by some. A departure suffices. Where fewer than df.votes informative
/// pairs are df.keep_delay or more apart (the ends of a drive, a short sight), iff one of these has
/// F >= df.f_single. No informative pair: static.
Verdict judgeVotes(const std::vector<PairVote>& votes,
                   ObjectClass object_class,
                   const DynamicConfig& config);

/// True when an informative pair saw through a segment: a vote for dynamic.
bool isSeenThrough(const PairVote& vote, const DynamicConfig& config);

/// True when a pair that is kParkedSeconds or more apart found a segment again where it is, for the
/// most part. @param points of the segment
bool isFoundAgain(const PairVote& vote, std::size_t points, const DynamicConfig& config);

/// True when it came: a scan 5 s before or more saw through where it stands (98 % of the points
/// that were looked for, at least half of all), and none before that one found it. Of fewer than 30
/// points that may be the edge of a dark thing of which nothing returned from afar: false.
bool cameHere(const std::vector<PairVote>& votes, std::size_t points, const DynamicConfig& config);

/// True when a segment was found again where it is, for the most part, by at least df.keep_hits
/// frames that are kParkedSeconds or more away: whatever its track did, here it stands.
bool isParked(const std::vector<PairVote>& votes, std::size_t points, const DynamicConfig& config);

constexpr double kParkedSeconds = 0.65;

}  // namespace segdf
