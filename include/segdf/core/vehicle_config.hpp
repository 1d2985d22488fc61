// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace segdf {

/// Clusters as large as a car: what belongs to them although it lies apart, and what of them is
/// ground (docs/segmentation.md, "Vehicles").
struct VehicleConfig {
  double length = 6.0;
  double width = 2.6;
  double top_min = 0.8;
  double top_max = 3.5;
  double behind = 1.5;
  double beside = 0.5;
  double fragment = 0.25;
  double fragment_height = 0.5;
  double foot = 0.02;
  double foot_share = 0.2;
  double foot_depth = 0.1;
  double foot_rise = 0.12;

  template <class Self, class Visitor>
  static void visit(Self& s, Visitor& v) {
    v.number("length", s.length, 0.0, 20.0, "m",
             "clusters up to this long ...; 0 = nothing of this is done");
    v.number("width", s.width, 0.0, 5.0, "m", "... and this wide ...");
    v.number("top_min", s.top_min, 0.0, 5.0, "m", "... whose top over ground is from this ...");
    v.number("top_max", s.top_max, 0.0, 10.0, "m", "... to this: vehicles may be so large");
    v.number("behind", s.behind, 0.0, 5.0, "m",
             "fragments that lie up to so far behind one belong to it ...");
    v.number("beside", s.beside, 0.0, 5.0, "deg", "... and up to so far beside it");
    v.number("fragment", s.fragment, 0.0, 1.0, "",
             "a cluster is a fragment up to this share of the other's points ...");
    v.number("fragment_height", s.fragment_height, 0.0, 5.0, "m", "... and this height");
    v.number("foot", s.foot, -1.0, 1.0, "m",
             "points of one below this over the plane of the ground around are ground, unless ...");
    v.number("foot_share", s.foot_share, 0.0, 1.0, "", "... they are a greater share of it ...");
    v.number("foot_depth", s.foot_depth, 0.0, 5.0, "m",
             "... or a hundredth of it lies lower under that plane than this");
    v.number("foot_rise", s.foot_rise, 0.0, 5.0, "m",
             "ground points in the footprint of one that are higher over that plane belong to it");
  }
};

}  // namespace segdf
