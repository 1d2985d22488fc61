// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/mesh.hpp"

#include <cmath>
#include <utility>

namespace segdf {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kSides = 12;           // of a cylinder
constexpr double kGroundStep = 1.0;  // metres along the street
constexpr double kReachStep = 2.0;   // metres across
constexpr double kKerbWidth = 0.05;  // metres from the road's height to the sidewalk's
constexpr float kAsphalt = 0.3F;
constexpr float kPavement = 0.4F;
constexpr float kGrass = 0.45F;

/// Corners of the solid's base, counter-clockwise, in its own frame.
std::vector<Eigen::Vector2d> outline(const Solid& solid) {
  std::vector<Eigen::Vector2d> corners;
  if (solid.shape == Solid::Shape::kBox) {
    const Eigen::Vector2d half = solid.size.head<2>() / 2.0;
    return {
        {-half.x(), -half.y()}, {half.x(), -half.y()}, {half.x(), half.y()}, {-half.x(), half.y()}};
  }
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2.0 * kPi * k / kSides;
    corners.emplace_back(solid.size.x() / 2.0 * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

void addTriangle(
    std::uint32_t a, std::uint32_t b, std::uint32_t c, const Material& material, Mesh& mesh) {
  mesh.triangles.push_back({a, b, c});
  mesh.materials.push_back(material);
}

/// A prism over the outline, narrower at the top by the taper: sides, top and bottom.
void addSolid(const Solid& solid, const Pose& map_T_object, const Material& material, Mesh& mesh) {
  const std::vector<Eigen::Vector2d> corners = outline(solid);
  const auto n = static_cast<std::uint32_t>(corners.size());
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const Eigen::AngleAxisd turn(solid.yaw, Eigen::Vector3d::UnitZ());
  for (double end : {-0.5, 0.5}) {
    for (Eigen::Vector2d corner : corners) {
      if (end > 0.0) corner = corner.cwiseProduct(solid.taper);
      Eigen::Vector3d local(corner.x(), corner.y(), end * solid.size.z());
      if (solid.shape == Solid::Shape::kWheel) std::swap(local.y(), local.z());
      local = solid.center + turn * local;
      mesh.vertices.emplace_back((map_T_object * local).cast<float>());
    }
  }
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    addTriangle(first + k, first + next, first + n + next, material, mesh);
    addTriangle(first + k, first + n + next, first + n + k, material, mesh);
  }
  for (std::uint32_t k = 2; k < n; ++k) {
    addTriangle(first, first + k, first + k - 1, material, mesh);
    addTriangle(first + n, first + n + k - 1, first + n + k, material, mesh);
  }
}

/// The ground as a grid along and across the street.
class GroundGrid {
 public:
  GroundGrid(const Terrain& ground, Mesh& mesh) : ground_(ground), mesh_(mesh) {
    for (double share = 1.0; share > 0.01; share -= 0.1) lines_.push_back(-1.0 - share);
    for (double y : {1.0, 0.8}) lines_.push_back(-y);
    inner_ = {-ground.half_road - kKerbWidth, -ground.half_road};
    for (double y = -0.8; y <= 0.81; y += 0.2) inner_.push_back(y * ground.half_road);
    inner_.insert(inner_.end(), {ground.half_road, ground.half_road + kKerbWidth});
  }

  void add() {
    const auto rows = static_cast<std::uint32_t>((ground_.end - ground_.begin) / kGroundStep) + 1;
    for (std::uint32_t row = 0; row < rows; ++row) {
      addVertices(ground_.begin + kGroundStep * row);
      if (row > 0) addCells();
    }
  }

 private:
  /// How far the land belongs to this place of the street and to no other one: terrain of two legs
  /// of a bent street must not lie upon each other.
  double reachAt(double along, double side) const {
    double reach = ground_.half_street;
    for (; reach + kReachStep <= ground_.reach; reach += kReachStep) {
      const Place place = ground_.line.place({along, side * (reach + kReachStep)});
      const double nearest = std::abs(ground_.line.nearest(place.x, place.y).across);
      if (nearest < reach + kReachStep - 0.1) break;
    }
    return reach;
  }

  /// Metres across of all vertices at this place, from right to left.
  std::vector<double> crossLines(double along) const {
    std::vector<double> lines;
    const auto outward = [&](double line, double reach) {
      if (line <= 1.0) return line * ground_.half_street;
      return ground_.half_street + (line - 1.0) * (reach - ground_.half_street);
    };
    const double right = reachAt(along, -1.0);
    const double left = reachAt(along, 1.0);
    for (double line : lines_) lines.push_back(-outward(-line, right));
    lines.insert(lines.end(), inner_.begin(), inner_.end());
    for (auto line = lines_.rbegin(); line != lines_.rend(); ++line) {
      lines.push_back(outward(-*line, left));
    }
    return lines;
  }

  void addVertices(double along) {
    now_ = crossLines(along);
    along_ = along;
    first_ = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (double across : now_) {
      const StreetPoint point{along, across};
      const Place place = ground_.line.place(point);
      mesh_.vertices.emplace_back(static_cast<float>(place.x), static_cast<float>(place.y),
                                  static_cast<float>(ground_.heightAt(place.x, place.y, point)));
    }
  }

  void addCells() {
    const auto across = static_cast<std::uint32_t>(now_.size());
    for (std::uint32_t j = 0; j + 1 < across; ++j) {
      const StreetPoint middle{along_ - kGroundStep / 2.0, (now_[j] + now_[j + 1]) / 2.0};
      const std::uint16_t semantic_class = ground_.classAt(middle);
      const Material material{semantic_class, reflectanceOf(semantic_class), false};
      const std::uint32_t corner = first_ - across + j;
      addTriangle(corner, corner + across, corner + across + 1, material, mesh_);
      addTriangle(corner, corner + across + 1, corner + 1, material, mesh_);
    }
  }

  float reflectanceOf(std::uint16_t semantic_class) const {
    if (semantic_class == Terrain::kTerrain) return kGrass;
    return semantic_class == Terrain::kSidewalk ? kPavement : kAsphalt;
  }

  const Terrain& ground_;
  Mesh& mesh_;
  std::vector<double> lines_;  // on the right, outermost first: shares of the street, then beyond
  std::vector<double> inner_;  // metres across, road and kerbs
  std::vector<double> now_;
  double along_ = 0.0;
  std::uint32_t first_ = 0;
};

/// A square without thickness.
void addLeaf(const Solid& solid, const Pose& map_T_object, const Material& material, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const Eigen::AngleAxisd turn(solid.yaw, Eigen::Vector3d::UnitZ());
  const double half = solid.size.x() / 2.0;
  for (double z : {-half, half}) {
    for (double y : {-half, half}) {
      const Eigen::Vector3d corner = solid.center + turn * Eigen::Vector3d(-z / 2.0, y, z);
      mesh.vertices.emplace_back((map_T_object * corner).cast<float>());
    }
  }
  addTriangle(first, first + 1, first + 3, material, mesh);
  addTriangle(first, first + 3, first + 2, material, mesh);
}

}  // namespace

void addSolids(const std::vector<Solid>& solids,
               std::uint32_t label,
               const Pose& map_T_object,
               Mesh& mesh) {
  for (const Solid& solid : solids) {
    const Material material{label, solid.reflectance, solid.glass};
    if (solid.shape == Solid::Shape::kLeaf) {
      addLeaf(solid, map_T_object, material, mesh);
    } else {
      addSolid(solid, map_T_object, material, mesh);
    }
  }
}

void addGround(const Terrain& ground, Mesh& mesh) { GroundGrid(ground, mesh).add(); }

}  // namespace segdf
