// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/point_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "segdf/core/parallel.hpp"

namespace segdf {

namespace {

constexpr std::int64_t kHalf = std::int64_t{1} << 20;  // cells on either side of the origin
constexpr unsigned kBits = 21;

std::uint64_t hashOf(std::uint64_t key) {  // a multiplication spreads neighbours over the table
  key *= 0x9E3779B97F4A7C15U;
  return key ^ (key >> 32U);
}

double squaredDistance(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return (a.cast<double>() - b.cast<double>()).squaredNorm();
}

}  // namespace

PointGrid::PointGrid(const std::vector<Eigen::Vector3f>& points, double cell) : cell_(cell) {
  if (!(cell > 0.0)) throw std::invalid_argument("the edge of a grid's cell must be above 0 m");
  if (points.size() >= std::numeric_limits<std::uint32_t>::max()) {
    throw std::invalid_argument("more points than a grid can hold");
  }
  sort(points);
  hashCells();
}

PointGrid::CellPlace PointGrid::cellPlace(const Eigen::Vector3f& point) const {
  CellPlace place{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double cell = std::floor(static_cast<double>(point[static_cast<int>(k)]) / cell_);
    if (!(std::abs(cell) < static_cast<double>(kHalf))) {
      throw std::invalid_argument("a point is not finite or too far from the origin of its map");
    }
    place[k] = static_cast<std::int64_t>(cell);
  }
  return place;
}

std::uint64_t PointGrid::keyOf(const CellPlace& place) const {
  std::uint64_t key = 0;
  for (const std::int64_t cell : place) {
    key = (key << kBits) | static_cast<std::uint64_t>(cell + kHalf);
  }
  return key;
}

void PointGrid::sort(const std::vector<Eigen::Vector3f>& points) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) order[i] = {keyOf(cellPlace(points[i])), i};
  std::sort(order.begin(), order.end());
  points_.reserve(points.size());
  index_.reserve(points.size());
  for (const auto& [key, i] : order) {
    const auto position = static_cast<std::uint32_t>(points_.size());
    if (cells_.empty() || cells_.back().key != key) cells_.push_back({key, position, position});
    ++cells_.back().end;
    points_.push_back(points[i]);
    index_.push_back(i);
  }
}

void PointGrid::hashCells() {
  std::size_t slots = 1;
  while (slots < 2 * cells_.size()) slots *= 2;
  mask_ = slots - 1;
  slots_.assign(slots, 0);
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    std::uint64_t slot = hashOf(cells_[c].key) & mask_;
    while (slots_[slot] != 0) slot = (slot + 1) & mask_;
    slots_[slot] = c + 1;
  }
}

const PointGrid::Cell* PointGrid::find(const CellPlace& place) const {
  if (cells_.empty()) return nullptr;
  const std::uint64_t key = keyOf(place);
  for (std::uint64_t slot = hashOf(key) & mask_; slots_[slot] != 0; slot = (slot + 1) & mask_) {
    if (cells_[slots_[slot] - 1].key == key) return &cells_[slots_[slot] - 1];
  }
  return nullptr;
}

double PointGrid::squaredDistanceToCell(const Eigen::Vector3f& place, const CellPlace& cell) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto x = static_cast<double>(place[static_cast<int>(k)]);
    const double low = static_cast<double>(cell[k]) * cell_;
    const double gap = std::max({low - x, x - low - cell_, 0.0});
    sum += gap * gap;
  }
  return sum;
}

double PointGrid::distanceToFaces(const Eigen::Vector3f& place, const CellPlace& cell) const {
  double least = cell_;
  for (std::size_t k = 0; k < 3; ++k) {
    const double in_cell =
        static_cast<double>(place[static_cast<int>(k)]) - static_cast<double>(cell[k]) * cell_;
    least = std::min({least, in_cell, cell_ - in_cell});
  }
  return std::max(least, 0.0);  // rounding may put a place on a face just outside
}

bool PointGrid::hasWithin(const Eigen::Vector3f& place, double radius) const {
  const double limit = radius * radius;
  const auto near = [&](const CellPlace& at) {
    const Cell* cell = find(at);
    if (cell == nullptr) return false;
    return std::any_of(
        points_.begin() + cell->begin, points_.begin() + cell->end,
        [&](const Eigen::Vector3f& p) { return squaredDistance(p, place) <= limit; });
  };
  const CellPlace own = cellPlace(place);
  if (near(own)) return true;
  const Eigen::Vector3f reach = Eigen::Vector3f::Constant(static_cast<float>(radius * 1.001));
  const CellPlace low = cellPlace(place - reach);
  const CellPlace high = cellPlace(place + reach);
  for (std::int64_t x = low[0]; x <= high[0]; ++x) {
    for (std::int64_t y = low[1]; y <= high[1]; ++y) {
      for (std::int64_t z = low[2]; z <= high[2]; ++z) {
        const CellPlace at{x, y, z};
        if (at == own || squaredDistanceToCell(place, at) > limit) continue;
        if (near(at)) return true;
      }
    }
  }
  return false;
}

std::vector<std::uint8_t> PointGrid::haveWithin(const std::vector<Eigen::Vector3f>& places,
                                                double radius,
                                                int threads) const {
  constexpr std::size_t kGrain = 4096;
  std::vector<std::uint8_t> found(places.size());
  parallelBlocks(places.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) found[i] = hasWithin(places[i], radius) ? 1 : 0;
  });
  return found;
}

std::optional<PointGrid::Neighbour> PointGrid::nearest(const Eigen::Vector3f& place,
                                                       double radius) const {
  double best = radius * radius;
  std::optional<Neighbour> found;
  const auto visit = [&](const CellPlace& at) {
    if (squaredDistanceToCell(place, at) > best) return;
    const Cell* cell = find(at);
    if (cell == nullptr) return;
    for (std::uint32_t i = cell->begin; i < cell->end; ++i) {
      const double distance = squaredDistance(points_[i], place);
      if (distance > best || (found && distance == best && index_[i] > found->index)) continue;
      best = distance;
      found = Neighbour{index_[i], std::sqrt(distance)};
    }
  };
  const CellPlace own = cellPlace(place);
  visit(own);
  // Shells of cells around the own one, until a shell is further away than the best point.
  const auto rings = static_cast<std::int64_t>(std::ceil(radius / cell_));
  const double inset = distanceToFaces(place, own);
  for (std::int64_t ring = 1; ring <= rings; ++ring) {
    const double gap = inset + static_cast<double>(ring - 1) * cell_;
    if (gap * gap > best) break;
    for (std::int64_t x = -ring; x <= ring; ++x) {
      for (std::int64_t y = -ring; y <= ring; ++y) {
        const bool side = std::abs(x) == ring || std::abs(y) == ring;
        for (std::int64_t z = -ring; z <= ring; z += side ? 1 : 2 * ring) {
          visit({own[0] + x, own[1] + y, own[2] + z});
        }
      }
    }
  }
  return found;
}

}  // namespace segdf
