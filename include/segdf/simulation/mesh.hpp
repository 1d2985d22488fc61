// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "segdf/simulation/scene.hpp"

namespace segdf {

/// What a ray learns from the triangle that it hits.
struct Material {
  std::uint32_t label = 0;  ///< truth: instance << 16 | class
  float reflectance = 0.0F;
  bool glass = false;
};

/// Triangles with one material each.
struct Mesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Material> materials;  ///< one for each triangle
};

/// Adds solids of an object, placed by map_T_object. @param label truth of what hits them
void addSolids(const std::vector<Solid>& solids,
               std::uint32_t label,
               const Pose& map_T_object,
               Mesh& mesh);

/// Adds the ground as a grid that has the kerbs as steps.
void addGround(const Terrain& ground, Mesh& mesh);

}  // namespace segdf
