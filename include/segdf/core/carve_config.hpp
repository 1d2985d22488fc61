// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace segdf {

/// Carving of persons off the clusters that hold them (docs/segmentation.md, "Carving").
struct CarveConfig {
  double jump = 0.06;
  int min_points = 30;
  double top_min = 1.3;
  double top_max = 2.1;
  double height = 0.5;
  double length_min = 0.3;
  double length_max = 1.1;
  double hidden = 0.3;
  double flanked = 0.3;
  double flanked_large = 0.5;

  template <class Self, class Visitor>
  static void visit(Self& s, Visitor& v) {
    v.number("jump", s.jump, 0.0, 5.0, "m",
             "neighbours in the range image that differ by more are of two pieces; 0 = no carving");
    v.integer("min_points", s.min_points, 3, 1000, "points", "a smaller piece is no person");
    v.number("top_min", s.top_min, 0.0, 5.0, "m", "person: top over ground from this ...");
    v.number("top_max", s.top_max, 0.0, 5.0, "m", "... to this");
    v.number("height", s.height, 0.0, 5.0, "m", "person: seen over at least this height");
    v.number("length_min", s.length_min, 0.0, 5.0, "m", "person: long side from this ...");
    v.number("length_max", s.length_max, 0.0, 5.0, "m", "... to this");
    v.number("hidden", s.hidden, 0.0, 1.0, "",
             "free: greatest share of its left and right border that lies behind what is beside");
    v.number("flanked", s.flanked, 0.0, 1.0, "",
             "free: greatest share of its upper border with more of the cluster to the side ...");
    v.number("flanked_large", s.flanked_large, 0.0, 1.0, "",
             "... and the same where the cluster is larger than any vehicle");
  }
};

}  // namespace segdf
