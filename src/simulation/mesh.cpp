// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/mesh.hpp"

#include <cmath>
#include <cstddef>

namespace segdf {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kSides = 12;           // of a cylinder
constexpr double kGroundStep = 1.0;  // metres along the street
constexpr double kKerbWidth = 0.05;  // metres from the road's height to the sidewalk's
constexpr float kAsphalt = 0.22F;
constexpr float kPavement = 0.32F;
constexpr float kGrass = 0.3F;

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

/// A prism over the outline: sides, top and bottom.
void addSolid(const Solid& solid, const Pose& map_T_object, const Material& material, Mesh& mesh) {
  const std::vector<Eigen::Vector2d> corners = outline(solid);
  const auto n = static_cast<std::uint32_t>(corners.size());
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const Eigen::AngleAxisd turn(solid.yaw, Eigen::Vector3d::UnitZ());
  for (double z : {-solid.size.z() / 2.0, solid.size.z() / 2.0}) {
    for (const Eigen::Vector2d& corner : corners) {
      const Eigen::Vector3d local =
          solid.center + turn * Eigen::Vector3d(corner.x(), corner.y(), z);
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

/// Lines of the ground grid across the street, with each kerb between two of them.
std::vector<double> crossLines(const StreetGround& ground) {
  std::vector<double> lines;
  for (double y = -ground.y_reach; y < -ground.half_street; y += 4.0) lines.push_back(y);
  for (double y : {-ground.half_street, -9.0, -ground.half_road - kKerbWidth, -ground.half_road}) {
    lines.push_back(y);
  }
  for (double y = -6.0; y <= 6.0; y += 2.0) lines.push_back(y);
  const std::size_t half = lines.size();
  for (std::size_t k = half; k-- > 0;) {
    if (lines[k] < -6.0) lines.push_back(-lines[k]);
  }
  return lines;
}

float groundReflectance(std::uint16_t semantic_class, const StreetGround& ground, double y) {
  if (semantic_class == ground.classAt(0.0)) return kAsphalt;
  return semantic_class == ground.classAt(ground.half_street) && std::abs(y) <= ground.half_street
             ? kPavement
             : kGrass;
}

}  // namespace

void addObject(const SceneObject& object, const Pose& map_T_object, Mesh& mesh) {
  for (const Solid& solid : object.solids) {
    addSolid(solid, map_T_object, {object.label(), solid.reflectance, solid.glass}, mesh);
  }
}

void addGround(const StreetGround& ground, Mesh& mesh) {
  const std::vector<double> lines = crossLines(ground);
  const auto across = static_cast<std::uint32_t>(lines.size());
  const auto along = static_cast<std::uint32_t>((ground.x_max - ground.x_min) / kGroundStep) + 1;
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::uint32_t i = 0; i < along; ++i) {
    const double x = ground.x_min + kGroundStep * i;
    for (double y : lines) {
      mesh.vertices.emplace_back(static_cast<float>(x), static_cast<float>(y),
                                 static_cast<float>(ground.heightAt(x, y)));
    }
  }
  for (std::uint32_t i = 0; i + 1 < along; ++i) {
    for (std::uint32_t j = 0; j + 1 < across; ++j) {
      const double middle = (lines[j] + lines[j + 1]) / 2.0;
      const std::uint16_t semantic_class = ground.classAt(middle);
      const Material material{semantic_class, groundReflectance(semantic_class, ground, middle),
                              false};
      const std::uint32_t corner = first + i * across + j;
      addTriangle(corner, corner + across, corner + across + 1, material, mesh);
      addTriangle(corner, corner + across + 1, corner + 1, material, mesh);
    }
  }
}

}  // namespace segdf
