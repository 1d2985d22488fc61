// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace segdf {

/// What is carved off the clusters that hold it, one kind of thing (docs/segmentation.md,
/// "Carving").
struct CarveConfig {
  double jump = 0.0;
  int min_points = 30;
  double top_min = 0.0;
  double top_max = 0.0;
  double height = 0.5;
  double length_min = 0.0;
  double length_max = 0.0;
  double width_max = 0.0;
  double open = 0.0;
  double hidden = 0.3;
  double flanked = 1.0;
  double flanked_large = 1.0;

  /// Standing and sitting.
  static CarveConfig person() {
    CarveConfig c;
    c.jump = 0.06;
    c.top_min = 1.3;
    c.top_max = 2.1;
    c.length_min = 0.3;
    c.length_max = 1.1;
    c.width_max = 1.1;
    c.flanked = 0.3;
    c.flanked_large = 0.5;
    return c;
  }

  /// Parked, seen from the side: one sees through it.
  static CarveConfig bicycle() {
    CarveConfig c;
    c.jump = 0.1;
    c.min_points = 60;
    c.top_min = 0.8;
    c.top_max = 1.3;
    c.length_min = 1.2;
    c.length_max = 2.0;
    c.width_max = 0.7;
    c.open = 0.45;
    return c;
  }

  template <class Self, class Visitor>
  static void visit(Self& s, Visitor& v) {
    v.number("jump", s.jump, 0.0, 5.0, "m",
             "neighbours in the range image that differ by more are of two pieces; 0 = no carving");
    v.integer("min_points", s.min_points, 3, 1000, "points", "a smaller piece stays where it is");
    v.number("top_min", s.top_min, 0.0, 5.0, "m", "top over ground from this ...");
    v.number("top_max", s.top_max, 0.0, 5.0, "m", "... to this");
    v.number("height", s.height, 0.0, 5.0, "m", "seen over at least this height");
    v.number("length_min", s.length_min, 0.0, 5.0, "m", "long side from this ...");
    v.number("length_max", s.length_max, 0.0, 5.0, "m", "... to this");
    v.number("width_max", s.width_max, 0.0, 5.0, "m", "short side up to this");
    v.number("open", s.open, 0.0, 2.0, "",
             "see-through: at least so many left and right border points for each of its points");
    v.number("hidden", s.hidden, 0.0, 1.0, "",
             "free: greatest share of that border that lies behind what is beside");
    v.number("flanked", s.flanked, 0.0, 1.0, "",
             "free: greatest share of its upper border beyond which its cluster goes on ...");
    v.number("flanked_large", s.flanked_large, 0.0, 1.0, "",
             "... and the same where the cluster is larger than any vehicle");
  }
};

}  // namespace segdf
