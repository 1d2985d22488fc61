// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/ground_cells.hpp"

#include <Eigen/Dense>

namespace segdf {

namespace {

constexpr double kMinPoints = 20.0;  // for a plane
// Square metres that hold the plane level where the ground is seen on one side only.
constexpr double kFlatness = 0.2;

}  // namespace

GroundCells::GroundCells(const std::vector<Eigen::AlignedBox2f>& areas,
                         const std::vector<Eigen::AlignedBox2f>& listed) {
  for (const Eigen::AlignedBox2f& area : areas) all_.extend(area);
  if (all_.isEmpty()) return;
  rows_ = cell(all_.max().x(), all_.min().x()) + 1;
  columns_ = cell(all_.max().y(), all_.min().y()) + 1;
  slot_.assign(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_), kUnused);
  std::int32_t used = 0;
  for (const Eigen::AlignedBox2f& area : areas) {
    forEachIndex(area, [&](std::size_t index) {
      if (slot_[index] == kUnused) slot_[index] = used++;
    });
  }
  cells_.resize(static_cast<std::size_t>(used));
  for (const Eigen::AlignedBox2f& area : listed) {
    forEachIndex(area, [this](std::size_t index) {
      cells_[static_cast<std::size_t>(slot_[index])].listed = true;
    });
  }
}

void GroundCells::add(const Point& p, std::uint32_t point) {
  if (!all_.contains(Eigen::Vector2f(p.x, p.y))) return;
  const std::int32_t slot = slot_[index(cell(p.x, all_.min().x()), cell(p.y, all_.min().y()))];
  if (slot == kUnused) return;
  GroundCell& to = cells_[static_cast<std::size_t>(slot)];
  to.moments.add(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
  if (to.listed) to.points.push_back(point);
}

std::optional<GroundPlane> planeAround(const std::vector<Point>& points,
                                       const GroundCells& cells,
                                       const Eigen::AlignedBox2f& area,
                                       const Eigen::AlignedBox2f& hole) {
  Moments sum;
  cells.forEachCell(area, [&](const GroundCell& cell) { sum.add(cell.moments); });
  Moments inside;
  cells.forEachCell(hole, [&](const GroundCell& cell) {
    for (std::uint32_t i : cell.points) {
      const Eigen::Vector3f p = points[i].position();
      if (!hole.contains(p.head<2>())) continue;
      inside.add(static_cast<double>(p.x()), static_cast<double>(p.y()),
                 static_cast<double>(p.z()));
    }
  });
  sum.add(inside, -1.0);
  if (sum.count < kMinPoints) return std::nullopt;
  const Eigen::Vector3d mean = sum.mean();
  const Eigen::Matrix3d covariance = sum.covariance();
  const Eigen::Matrix2d spread =
      covariance.topLeftCorner<2, 2>() + kFlatness * Eigen::Matrix2d::Identity();
  return GroundPlane{mean.head<2>(), spread.inverse() * covariance.topRightCorner<2, 1>(),
                     mean.z()};
}

}  // namespace segdf
