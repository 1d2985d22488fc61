// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "segdf/core/enum_name.hpp"

/// Parameters of the dynamic filter; see core/config.hpp for how they are listed.
namespace segdf {

/// Which dynamic filter runs (method.md 0).
enum class FilterMode { kLiteral, kSegdf };

/// What becomes of an object that stood still for a part of the drive.
enum class SemiStatic { kRemove, kKeepWhileParked };

/// Algorithm 2: as printed (method.md 6.2), or by visibility over many frames (6.4 to 6.8, 6.12).
struct DynamicConfig {
  static constexpr std::array<EnumName<FilterMode>, 2> kModes{
      {{FilterMode::kLiteral, "literal"}, {FilterMode::kSegdf, "segdf"}}};

  static constexpr std::array<EnumName<SemiStatic>, 2> kSemiStatic{
      {{SemiStatic::kRemove, "remove"}, {SemiStatic::kKeepWhileParked, "keep_while_parked"}}};

  FilterMode mode = FilterMode::kSegdf;
  double thre_occu = 0.5;
  double assoc = 0.15;
  double tau = 0.30;
  double tau_ratio = 0.01;
  double margin = 0.15;
  double dtheta_v = 0.5;
  double dphi_v = 0.4;
  std::array<double, 7> times{0.1, 0.3, 0.6, 1.0, 2.0, 3.0, 5.0};
  std::array<double, 7> ways{2.0, 4.0, 6.0, 10.0, 16.0, 24.0, 32.0};
  int window = 64;
  SemiStatic semi_static = SemiStatic::kRemove;
  double min_quality = 0.4;
  int vis_min = 4;
  double vis_frac = 0.20;
  double f_dyn = 0.30;
  double f_stat = 0.10;
  double f_single = 0.70;
  int votes = 3;
  double vote_share = 0.20;
  int split_min = 12;
  int keep_min = 30;
  int keep_hits = 3;
  double keep_delay = 0.5;
  int loose_votes = 3;
  int left_looks = 4;
  double foot_height = 0.3;
  double foot_margin = 0.20;
  double foot_bottom = 0.06;

  template <class Self, class Visitor>
  static void visit(Self& s, Visitor& v) {
    v.choice("mode", s.mode, kModes,
             "literal: Algorithm 2 as printed, on consecutive key frames; segdf: by visibility "
             "over many frames");
    v.number("thre_occu", s.thre_occu, 0.0, 1.0, "",
             "threOccu: share of an instance's voxels that must be found again");
    v.number(
        "assoc", s.assoc, 0.01, 1.0, "",
        "share of an instance's voxels that must touch a segment of the next key frame for a link");
    v.number("tau", s.tau, 0.05, 2.0, "m", "visibility: tolerance in range ...");
    v.number("tau_ratio", s.tau_ratio, 0.0, 0.1, "", "... or this share of the range");
    v.number("margin", s.margin, 0.0, 1.0, "m", "visibility: tolerance across the ray");
    v.number("dtheta_v", s.dtheta_v, 0.1, 10.0, "deg",
             "visibility: polar bin, the gap between lasers");
    v.number("dphi_v", s.dphi_v, 0.1, 5.0, "deg", "visibility: azimuth bin");
    v.numbers("times", s.times, 0.01, 100.0, "s", "key frames are compared over these times ...");
    v.numbers("ways", s.ways, 0.1, 1000.0, "m", "... and these ways, both before and after");
    v.integer("window", s.window, 2, 1000, "key frames",
              "sliding window; a decision comes up to five later");
    v.choice("semi_static", s.semi_static, kSemiStatic,
             "what stood for a while and moved before or after: goes, or stays while it stands");
    v.number("min_quality", s.min_quality, 0.0, 1.0, "",
             "share of points that must fit a pair's pose, else the pair is dropped");
    v.integer("vis_min", s.vis_min, 1, 1000, "points",
              "a pair says something of an instance when "
              "so many of its points are seen free or hit ...");
    v.number("vis_frac", s.vis_frac, 0.0, 1.0, "", "... and this share of them");
    v.number("f_dyn", s.f_dyn, 0.0, 1.0, "", "free share that is a vote for dynamic");
    v.number("f_stat", s.f_stat, 0.0, 1.0, "", "free share up to which it is a vote for static");
    v.number("f_single", s.f_single, 0.0, 1.0, "",
             "free share that suffices where fewer pairs than votes say anything");
    v.integer("votes", s.votes, 1, 100, "pairs", "votes that make an instance dynamic, at least");
    v.number("vote_share", s.vote_share, 0.0, 1.0, "", "... and this share of the pairs");
    v.integer("split_min", s.split_min, 1, 1000, "points", "smallest dynamic part of an instance");
    v.integer("keep_min", s.keep_min, 1, 1000, "points",
              "smallest static part of a dynamic instance");
    v.integer("keep_hits", s.keep_hits, 1, 100, "pairs", "hits that make a point static");
    v.number("keep_delay", s.keep_delay, 0.0, 10.0, "s",
             "only hits from frames at least so far away in time count");
    v.integer("loose_votes", s.loose_votes, 1, 100, "pairs",
              "free pairs that remove a point that is in no instance");
    v.integer("left_looks", s.left_looks, 0, 100, "looks",
              "in a row, half a second apart, that see through where something stood before its "
              "frames left the window, and remove it there after all; 0: none does");
    v.number("foot_height", s.foot_height, 0.0, 2.0, "m",
             "below: an instance and the ground around it may have been confused");
    v.number("foot_margin", s.foot_margin, 0.0, 1.0, "m",
             "low points up to so far outside a removed instance belong to it");
    v.number("foot_bottom", s.foot_bottom, -1.0, 1.0, "m", "lowest such point");
  }
};

}  // namespace segdf
