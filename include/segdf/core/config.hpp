// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "segdf/core/carve_config.hpp"
#include "segdf/core/dynamic_config.hpp"
#include "segdf/core/enum_name.hpp"
#include "segdf/core/vehicle_config.hpp"

/// Parameters of every stage. Each struct lists its parameters once, in `visit`: name, bounds, unit
/// and meaning. Reading YAML or ROS parameters, checking bounds, and writing the effective
/// configuration all walk that one list. Defaults are those of an HDL-64E; cfg/sensors/*.yaml
/// overrides them.
///
/// A visitor offers
///   number(name, double&, min, max, unit, meaning)
///   integer(name, int&, min, max, unit, meaning)
///   numbers(name, std::array<double, N>&, min, max, unit, meaning)
///   choice(name, Enum&, array of EnumName<Enum>, meaning)
///   section(name, struct&, meaning)
namespace segdf {

/// What is left out before anything else, and when a scan becomes a key frame (method.md 1).
struct InputConfig {
  double min_range = 1.2;
  double max_range = 120.0;
  std::array<double, 4> ego_box{0.0, 0.0, 0.0, 0.0};
  double keyframe_distance = 0.0;
  double keyframe_angle = 0.0;
  double keyframe_time = 1.0;
  double max_misfit = 0.10;
  double max_jump = 1.0;

  template <class Self, class Visitor>
  static void visit(Self& s, Visitor& v) {
    v.number("min_range", s.min_range, 0.0, 20.0, "m", "nearer points are not judged");
    v.number("max_range", s.max_range, 5.0, 500.0, "m", "farther points are not judged");
    v.numbers(
        "ego_box", s.ego_box, -20.0, 20.0, "m",
        "x_min x_max y_min y_max in the sensor frame: points on the own vehicle are not judged");
    v.number("keyframe_distance", s.keyframe_distance, 0.0, 100.0, "m",
             "way between key frames; 0 makes every scan a key frame");
    v.number("keyframe_angle", s.keyframe_angle, 0.0, 180.0, "deg",
             "turn that makes a key frame however short the way; 0 = no turn does");
    v.number("keyframe_time", s.keyframe_time, 0.0, 3600.0, "s",
             "wait that makes one: who stands still must see what drives off; 0 = no wait does");
    v.number("max_misfit", s.max_misfit, 0.01, 10.0, "m",
             "warn when the median misfit of consecutive key frames is above");
    v.number("max_jump", s.max_jump, 0.0, 1000.0, "m",
             "a pose that motion does not explain by more is a loop closure: the window is decided "
             "and starts anew; 0 = never");
  }
};

/// Concentric-zone ground extraction (method.md 2, after Patchwork [37]).
struct GroundConfig {
  double sensor_height = 0.0;
  double l_min = 2.7;
  double l_max = 80.0;
  int tie_beams = 32;
  int n_min = 10;
  int n_lpr = 20;
  int n_iter = 3;
  double th_seed = 0.3;
  double th_dist = 0.1;
  double below_tol = 0.5;
  double uprightness = 0.9;
  double wall_dist = 0.1;
  std::array<double, 4> elevation{0.523, 0.746, 0.879, 1.125};
  std::array<double, 4> flatness{0.0005, 0.000725, 0.001, 0.001};
  double patch_step = 0.2;
  double patch_slope = 0.15;
  double foot_reach = 0.3;
  double foot_rise = 0.15;
  double touch_reach = 0.2;
  double touch_height = 0.04;

  template <class Self, class Visitor>
  static void visit(Self& s, Visitor& v) {
    v.number("sensor_height", s.sensor_height, 0.0, 10.0, "m",
             "sensor above ground; 0 = measured in the first scans");
    v.number("l_min", s.l_min, 0.1, 20.0, "m", "inner border of the zones");
    v.number("l_max", s.l_max, 10.0, 300.0, "m", "outer border of the zones");
    v.integer("tie_beams", s.tie_beams, 0, 256, "",
              "with so many lasers or fewer, rings begin and end between lasers; 0 = never");
    v.integer("n_min", s.n_min, 3, 1000, "points", "a patch with fewer has no ground");
    v.integer("n_lpr", s.n_lpr, 1, 1000, "points", "lowest points that give the seed height");
    v.integer("n_iter", s.n_iter, 1, 20, "", "plane fits per patch");
    v.number("th_seed", s.th_seed, 0.01, 5.0, "m", "seeds lie below seed height plus this");
    v.number("th_dist", s.th_dist, 0.01, 5.0, "m", "ground lies below plane plus this");
    v.number("below_tol", s.below_tol, 0.01, 10.0, "m", "ground lies above plane minus this");
    v.number("uprightness", s.uprightness, 0.0, 1.0, "", "least z of the plane's normal");
    v.number("wall_dist", s.wall_dist, 0.01, 1.0, "m",
             "zone 0: points nearer to a near-vertical plane are no seeds");
    v.numbers("elevation", s.elevation, 0.0, 10.0, "m",
              "rings 0..3: highest patch mean above the expected ground");
    v.numbers("flatness", s.flatness, 0.0, 1.0, "",
              "rings 0..3: a higher patch is ground when its change of curvature is below");
    v.number("patch_step", s.patch_step, 0.0, 10.0, "m",
             "no ground: a patch higher than the next inwards or beside it by more than this ...");
    v.number("patch_slope", s.patch_slope, 0.0, 5.0, "", "... plus this share of their distance");
    v.number("foot_reach", s.foot_reach, 0.0, 5.0, "m",
             "no ground: the lasers above see something nearer to the point than this ...");
    v.number("foot_rise", s.foot_rise, 0.01, 5.0, "m", "... that rises over it by this");
    v.number("touch_reach", s.touch_reach, 0.0, 5.0, "m",
             "no ground: an object point is nearer than this ...");
    v.number("touch_height", s.touch_height, 0.0, 5.0, "m",
             "... and the point this high over the local ground");
  }
};

/// Range image that carries neighbourhoods and normals (method.md 3.6).
struct RangeImageConfig {
  int beams = 64;
  int columns = 2048;
  double elevation_min = -25.0;
  double elevation_max = 3.0;
  double gate = 0.3;
  double gate_ratio = 0.03;

  template <class Self, class Visitor>
  static void visit(Self& s, Visitor& v) {
    v.integer("beams", s.beams, 4, 256, "", "lasers of the sensor, rows of the image");
    v.integer("columns", s.columns, 64, 8192, "", "columns over 360 degrees");
    v.number("elevation_min", s.elevation_min, -90.0, 90.0, "deg", "lowest laser");
    v.number("elevation_max", s.elevation_max, -90.0, 90.0, "deg", "highest laser");
    v.number("gate", s.gate, 0.01, 5.0, "m", "neighbours differ by less in range ...");
    v.number("gate_ratio", s.gate_ratio, 0.0, 1.0, "", "... or by less than this share of it");
  }
};

/// Named parameter sets of formula (6), one per kind of sensor (method.md 3.3).
enum class IntensityProfile {
  kKittiHdl64,
  kVelodyneReflectivity,
  kOusterReflectivity,
  kOusterSignal,
  kRaw,
  kLiteral,
};

/// Intensity calibration, formula (6).
struct IntensityConfig {
  static constexpr std::array<EnumName<IntensityProfile>, 6> kProfiles{
      {{IntensityProfile::kKittiHdl64, "kitti_hdl64"},
       {IntensityProfile::kVelodyneReflectivity, "velodyne_reflectivity"},
       {IntensityProfile::kOusterReflectivity, "ouster_reflectivity"},
       {IntensityProfile::kOusterSignal, "ouster_signal"},
       {IntensityProfile::kRaw, "raw"},
       {IntensityProfile::kLiteral, "literal"}}};

  IntensityProfile profile = IntensityProfile::kKittiHdl64;
  double full_scale = 0.0;
  double r_ref = 10.0;
  double r_near = 10.0;
  double r_cap = 60.0;
  double c_min = 0.2;

  template <class Self, class Visitor>
  static void visit(Self& s, Visitor& v) {
    v.choice("profile", s.profile, kProfiles,
             "how the sensor's intensity depends on range and angle");
    v.number("full_scale", s.full_scale, 0.0, 1e6, "",
             "sensor value that becomes 1, at r_ref and facing; 0 = the profile's");
    v.number("r_ref", s.r_ref, 0.1, 100.0, "m", "range at which the calibration changes nothing");
    v.number("r_near", s.r_near, 0.1, 100.0, "m", "nearer points are treated as at this range");
    v.number("r_cap", s.r_cap, 1.0, 300.0, "m", "farther points are treated as at this range");
    v.number("c_min", s.c_min, 0.01, 1.0, "", "least cosine of the incidence angle");
  }
};

/// Intensity gate of Algorithm 1, lines 5-11 (method.md 4.5).
enum class IntensityGate { kOff, kEvidence, kLiteral };

/// Curved voxels (7) and Algorithm 1 (method.md 4).
struct CurvedVoxelConfig {
  static constexpr std::array<EnumName<IntensityGate>, 3> kGates{
      {{IntensityGate::kOff, "off"},
       {IntensityGate::kEvidence, "evidence"},
       {IntensityGate::kLiteral, "literal"}}};

  double drho = 0.20;
  double growth = 0.0;
  double dtheta = 1.2;
  double dphi = 0.4;
  IntensityGate gate = IntensityGate::kOff;
  int ext = 2;
  double thre_av = 0.25;
  double thre_cov = 0.15;
  int n_noise = 10;
  double merge_diagonal = 6.5;
  double merge_height = 3.2;
  double merge_long_side = 6.0;
  double merge_short_side = 4.5;

  template <class Self, class Visitor>
  static void visit(Self& s, Visitor& v) {
    v.number("drho", s.drho, 0.01, 5.0, "m", "range step of the first cell");
    v.number("growth", s.growth, 0.0, 0.1, "m", "growth of the range step per cell");
    v.number("dtheta", s.dtheta, 0.05, 30.0, "deg", "polar step");
    v.number("dphi", s.dphi, 0.05, 30.0, "deg", "azimuth step (rounded so that 360 is a multiple)");
    v.choice("gate", s.gate, kGates,
             "intensity in stage 1: ignored, cuts on evidence, or as printed");
    v.integer("ext", s.ext, 1, 4, "cells", "reach of stage 2");
    v.number("thre_av", s.thre_av, 0.0, 1.0, "", "threAV: greatest difference of mean intensity");
    v.number("thre_cov", s.thre_cov, 0.0, 1.0, "",
             "threCOV: a voxel with a greater standard deviation is not credible");
    v.integer("n_noise", s.n_noise, 1, 1000, "points", "a smaller cluster is noise");
    v.number("merge_diagonal", s.merge_diagonal, 0.5, 50.0, "m", "largest merged object: diagonal");
    v.number("merge_height", s.merge_height, 0.5, 20.0, "m", "largest merged object: height");
    v.number("merge_long_side", s.merge_long_side, 0.5, 50.0, "m",
             "largest merged object: long side");
    v.number("merge_short_side", s.merge_short_side, 0.5, 50.0, "m",
             "largest merged object: short side");
  }
};

/// Rules of the geometric classification (method.md 5.4).
struct ClassConfig {
  double airborne = 1.5;
  double topcut = 0.3;
  double tall_cut = 1.9;
  double tall = 2.6;
  double leafy_smooth = 0.25;
  double leafy_curvature = 0.05;
  double leafy_vehicle = 0.1;
  double leafy_vertical = 0.6;
  double bush_smooth = 0.05;
  double bush_curvature = 0.10;
  double bush_vertical = 0.5;
  double rough = 0.04;
  double rough_smooth = 0.2;
  double wall_vertical = 0.7;
  double wall_thickness = 0.7;
  double wall_sigma = 0.25;
  double front_vertical = 0.8;
  double front_contact = 0.05;
  double front_width = 0.7;
  double front_ratio = 3.0;
  double beside = 5.0;
  double pole_side = 0.8;
  double pole_bottom = 0.6;
  double large_length = 19.0;
  double large_width = 3.0;
  double large_height = 4.5;
  double long_length = 7.0;
  double long_width = 3.0;
  double low = 0.35;

  template <class Self, class Visitor>
  static void visit(Self& s, Visitor& v) {
    v.number("airborne", s.airborne, 0.0, 10.0, "m", "lowest point above: no ground contact");
    v.number("topcut", s.topcut, 0.0, 1.0, "", "share of columns cut by the field of view");
    v.number("tall_cut", s.tall_cut, 0.0, 10.0, "m", "a cut object above this height is tall");
    v.number("tall", s.tall, 0.0, 10.0, "m", "any object above this height is tall");
    v.number("leafy_smooth", s.leafy_smooth, 0.0, 1.0, "", "foliage: share of smooth points below");
    v.number("leafy_curvature", s.leafy_curvature, 0.0, 1.0, "", "foliage: local curvature above");
    v.number("leafy_vehicle", s.leafy_vehicle, 0.0, 1.0, "",
             "... if as large as a vehicle: share of smooth points below ...");
    v.number("leafy_vertical", s.leafy_vertical, 0.0, 1.0, "",
             "... and share of vertical normals below");
    v.number("bush_smooth", s.bush_smooth, 0.0, 1.0, "",
             "bush as large as a car: share of smooth points below ...");
    v.number("bush_curvature", s.bush_curvature, 0.0, 1.0, "", "... local curvature above ...");
    v.number("bush_vertical", s.bush_vertical, 0.0, 1.0, "",
             "... and share of vertical normals below");
    v.number("rough", s.rough, 0.0, 1.0, "m",
             "rough foliage: distance from the neighbours' line along the ray above ...");
    v.number("rough_smooth", s.rough_smooth, 0.0, 1.0, "", "... and share of smooth points below");
    v.number("wall_vertical", s.wall_vertical, 0.0, 1.0, "",
             "wall: share of vertical normals above");
    v.number("wall_thickness", s.wall_thickness, 0.0, 5.0, "m", "wall: thinner than this ...");
    v.number("wall_sigma", s.wall_sigma, 0.0, 5.0, "m", "... or with less spread across");
    v.number("front_vertical", s.front_vertical, 0.0, 1.0, "",
             "front of a house: share of vertical normals above ...");
    v.number("front_contact", s.front_contact, 0.0, 1.0, "",
             "... share of its footprint that reaches the ground above ...");
    v.number("front_width", s.front_width, 0.0, 20.0, "m", "... and thinner than this ...");
    v.number("front_ratio", s.front_ratio, 1.0, 50.0, "",
             "... by this factor than long, or longer than 13 m");
    v.number("beside", s.beside, 0.0, 50.0, "m",
             "wall or front as large as a bus whose middle is nearer: it may be one");
    v.number("pole_side", s.pole_side, 0.0, 5.0, "m", "pole or trunk: tall and no wider ...");
    v.number("pole_bottom", s.pole_bottom, 0.0, 5.0, "m", "... and reaching down to this height");
    v.number("large_length", s.large_length, 1.0, 100.0, "m", "tall and longer: no vehicle");
    v.number("large_width", s.large_width, 1.0, 20.0, "m", "tall and wider: no vehicle");
    v.number("large_height", s.large_height, 1.0, 20.0, "m", "higher over ground: no vehicle");
    v.number("long_length", s.long_length, 1.0, 100.0, "m", "longer: no car");
    v.number("long_width", s.long_width, 1.0, 20.0, "m", "wider: no car");
    v.number("low", s.low, 0.0, 2.0, "m", "lower: unknown (kerb, grass)");
  }
};

/// The static instance map.
struct MapConfig {
  double voxel = 0.0;
  double live_voxel = 0.2;

  template <class Self, class Visitor>
  static void visit(Self& s, Visitor& v) {
    v.number("voxel", s.voxel, 0.0, 5.0, "m", "grid of static_map.pcd; 0 keeps every point");
    v.number("live_voxel", s.live_voxel, 0.02, 5.0, "m",
             "grid of the map that the nodelet publishes");
  }
};

/// All of it.
struct Config {
  InputConfig input;
  GroundConfig ground;
  RangeImageConfig range_image;
  IntensityConfig intensity;
  CurvedVoxelConfig cvi;
  CarveConfig person = CarveConfig::person();
  CarveConfig bicycle = CarveConfig::bicycle();
  VehicleConfig vehicle;
  ClassConfig classes;
  DynamicConfig df;
  MapConfig map;

  template <class Self, class Visitor>
  static void visit(Self& s, Visitor& v) {
    v.section("input", s.input, "what comes in");
    v.section("ground", s.ground, "ground extraction, concentric zones");
    v.section("range_image", s.range_image, "the sensor's grid, for neighbourhoods and normals");
    v.section("intensity", s.intensity, "intensity calibration, formula (6)");
    v.section("cvi", s.cvi, "curved voxels (7) and clustering, Algorithm 1");
    v.section("carve_person", s.person, "persons carved off the clusters that hold them");
    v.section("carve_bicycle", s.bicycle, "bicycles likewise");
    v.section("vehicle", s.vehicle, "what belongs to clusters as large as a car");
    v.section("class", s.classes, "geometric classification, draft III-C");
    v.section("df", s.df, "dynamic filter, Algorithm 2");
    v.section("map", s.map, "static instance map");
  }
};

/// Checks every bound. @throws std::invalid_argument "parameter ground.th_seed = 9 is out of [0.01,
/// 5] m".
void validate(const Config& config);

/// Shortest text that reads back as the same number ("0.2", "1.125", "64").
std::string formatNumber(double value);

}  // namespace segdf
