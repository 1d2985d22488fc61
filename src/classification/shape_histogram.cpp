// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/classification/shape_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

#include <Eigen/Core>

#include "segdf/segmentation/arc_tangent.hpp"

namespace segdf {

namespace {

// As many as a mean cluster allows in a quarter of a millisecond.
constexpr std::size_t kTriples = 1200;
constexpr std::size_t kMaxAttempts = 3 * kTriples;
constexpr std::size_t kMinPoints = 10;
constexpr int kGrid = 64;
constexpr float kHalfGrid = 32.0F;
constexpr float kRadius = 31.5F;  // cells
// Three points on a line: PCL's bound on the squared area, in cells to the fourth power at a grid
// 64 times as fine.
constexpr float kMinSquaredArea = 1.0F;
// A line has at most one cell off the surface, or no more than seven on it, or is mixed.
constexpr int kInsideSlack = 1;
constexpr int kOutsideCells = 7;
// The same for the three lines of a triangle.
constexpr int kTriangleSlack = 3;
constexpr int kTriangleOutsideCells = 21;
// Every second cell of a line is looked at: the surface is three cells thick.
constexpr int kStride = 2;

enum Kind : std::size_t { kInside, kOutside, kMixed };
constexpr std::size_t kAngle = 0;
constexpr std::size_t kArea = 3;
constexpr std::size_t kDistance = 6;
constexpr std::size_t kRatio = 9;
constexpr std::array<float, ShapeHistogram::kHistograms> kWeights{0.5F, 0.5F, 0.5F, 0.5F, 0.5F,
                                                                  1.0F, 0.5F, 2.0F, 2.0F, 1.0F};

/// splitmix64.
class Generator {
 public:
  explicit Generator(std::uint64_t seed) : state_(seed) {}

  std::size_t below(std::size_t n) {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    z ^= z >> 31U;
    return static_cast<std::size_t>(((z >> 32U) * n) >> 32U);
  }

 private:
  std::uint64_t state_;
};

/// The cluster about its centre, scaled to the grid, in an order that does not depend on the scan.
std::vector<Eigen::Vector3f> normalised(const std::vector<Point>& points,
                                        const std::vector<std::uint32_t>& indices) {
  std::vector<Eigen::Vector3f> cloud;
  cloud.reserve(indices.size());
  for (std::uint32_t i : indices) cloud.push_back(points[i].position());
  std::sort(cloud.begin(), cloud.end(), [](const auto& a, const auto& b) {
    return std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
  });
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& p : cloud) sum += p.cast<double>();
  const Eigen::Vector3f centre = (sum / static_cast<double>(cloud.size())).cast<float>();
  float radius = 0.0F;
  for (auto& p : cloud) {
    p -= centre;
    radius = std::max(radius, p.norm());
  }
  const float scale = radius > 0.0F ? kRadius / radius : 0.0F;
  for (auto& p : cloud) p *= scale;
  return cloud;
}

/// FNV-1a over the coordinates.
std::uint64_t seedOf(const std::vector<Eigen::Vector3f>& cloud) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const auto& p : cloud) {
    for (int k = 0; k < 3; ++k) {
      hash ^= static_cast<std::uint64_t>(static_cast<std::int64_t>(p[k] * 256.0F));
      hash *= 0x100000001B3U;
    }
  }
  return hash;
}

/// Which cells the surface fills, one bit each: small enough for the processor's nearest cache.
class SurfaceGrid {
 public:
  explicit SurfaceGrid(const std::vector<Eigen::Vector3f>& cloud) {
    for (const auto& p : cloud) fillAround(cellOf(p));
  }

  struct Line {
    int cells = 0;
    int filled = 0;

    Kind kind() const {
      if (cells - filled <= kInsideSlack) return kInside;
      return filled <= kOutsideCells ? kOutside : kMixed;
    }
  };

  Line trace(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const {
    const Cell a = cellOf(from);
    const Cell b = cellOf(to);
    const int length = (b - a).cwiseAbs().maxCoeff();
    Line line;
    line.cells = length + 1;
    // Positions in 16 bits behind the point; half a cell for rounding.
    const float scale = 65536.0F * kStride / static_cast<float>(std::max(length, 1));
    const Cell step = ((b - a).cast<float>() * scale).cast<int>();
    Cell at = a * 65536 + Cell::Constant(32768);
    int filled = 0;
    for (int k = 0; k <= length; k += kStride, at += step) {
      filled += isFilled(at.x() >> 16, at.y() >> 16, at.z() >> 16);
    }
    line.filled = std::min(filled * kStride, line.cells);
    return line;
  }

 private:
  using Cell = Eigen::Vector3i;

  static Cell cellOf(const Eigen::Vector3f& p) {
    const auto cell = [](float value) {
      return std::clamp(static_cast<int>(value + kHalfGrid), 0, kGrid - 1);
    };
    return {cell(p.x()), cell(p.y()), cell(p.z())};
  }

  static std::size_t columnIndex(int x, int y) {
    return static_cast<std::size_t>(x) * kGrid + static_cast<std::size_t>(y);
  }

  int isFilled(int x, int y, int z) const {
    return static_cast<int>((columns_[columnIndex(x, y)] >> z) & 1U);
  }

  void fillAround(const Cell& cell) {
    const std::uint64_t three = cell.z() > 0 ? std::uint64_t{7} << (cell.z() - 1) : 3U;
    for (int x = std::max(0, cell.x() - 1); x <= std::min(kGrid - 1, cell.x() + 1); ++x) {
      for (int y = std::max(0, cell.y() - 1); y <= std::min(kGrid - 1, cell.y() + 1); ++y) {
        columns_[columnIndex(x, y)] |= three;
      }
    }
  }

  std::array<std::uint64_t, static_cast<std::size_t>(kGrid) * kGrid> columns_{};
};

/// What one triple adds.
struct Triple {
  std::array<float, 3> sides{};
  std::array<SurfaceGrid::Line, 3> lines;
  std::array<float, 3> angles{};  ///< as shares of a right angle, each facing the side of its index
  float root_of_area = 0.0F;
};

/// Angle between two sides, 0 to 1 for 0 to 90 degrees.
float shareOfRightAngle(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  constexpr double kHalfPi = 3.14159265358979323846 / 2.0;
  const auto across = static_cast<double>(a.cross(b).norm());
  return static_cast<float>(arcTangent2(across, std::abs(static_cast<double>(a.dot(b)))) / kHalfPi);
}

std::optional<Triple> measure(const std::vector<Eigen::Vector3f>& cloud,
                              const SurfaceGrid& grid,
                              Generator& generator) {
  const auto& p = cloud[generator.below(cloud.size())];
  const auto& q = cloud[generator.below(cloud.size())];
  const auto& r = cloud[generator.below(cloud.size())];
  const Eigen::Vector3f pq = q - p;
  const Eigen::Vector3f pr = r - p;
  const Eigen::Vector3f rq = q - r;
  const float doubled_area = pq.cross(pr).norm();
  if (!(doubled_area * doubled_area > 4.0F * kMinSquaredArea)) return std::nullopt;
  Triple triple;
  triple.sides = {pq.norm(), pr.norm(), rq.norm()};
  triple.lines = {grid.trace(p, q), grid.trace(p, r), grid.trace(r, q)};
  triple.angles = {shareOfRightAngle(rq, pr), shareOfRightAngle(rq, pq), shareOfRightAngle(pq, pr)};
  triple.root_of_area = std::sqrt(doubled_area / 2.0F);
  return triple;
}

Kind kindOf(const Triple& triple) {
  int cells = 0;
  int filled = 0;
  for (const auto& line : triple.lines) {
    cells += line.cells;
    filled += line.filled;
  }
  if (filled <= kTriangleOutsideCells) return kOutside;
  return cells - filled <= kTriangleSlack ? kInside : kMixed;
}

/// Adds up triples. Distances and areas are binned as shares of the greatest, known at the end
/// only.
class Histograms {
 public:
  explicit Histograms(const std::vector<Triple>& triples) {
    float longest = 0.0F;
    float widest = 0.0F;
    for (const Triple& t : triples) {
      longest = std::max(longest, *std::max_element(t.sides.begin(), t.sides.end()));
      widest = std::max(widest, t.root_of_area);
    }
    for (const Triple& t : triples) add(t, longest, widest);
  }

  ShapeHistogram normalisedBins() {
    ShapeHistogram result;
    for (std::size_t h = 0; h < ShapeHistogram::kHistograms; ++h) {
      for (std::size_t b = 0; b < ShapeHistogram::kBins; ++b) {
        bins_[h * ShapeHistogram::kBins + b] *= kWeights[h];
      }
    }
    const float sum = std::accumulate(bins_.begin(), bins_.end(), 0.0F);
    if (!(sum > 0.0F)) return result;
    std::transform(bins_.begin(), bins_.end(), result.bins.begin(),
                   [sum](float value) { return value / sum; });
    result.valid = true;
    return result;
  }

 private:
  /// @param share 0 to 1
  void count(std::size_t histogram, float share, float weight) {
    const auto bin = static_cast<std::size_t>(
        std::lround(std::clamp(share, 0.0F, 1.0F) * static_cast<float>(ShapeHistogram::kBins - 1)));
    bins_[histogram * ShapeHistogram::kBins + bin] += weight;
  }

  void add(const Triple& t, float longest, float widest) {
    const Kind kind = kindOf(t);
    count(kArea + kind, t.root_of_area / widest, 1.0F);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& line = t.lines[k];
      // An angle counts by the length of the side that faces it.
      count(kAngle + kind, t.angles[k], static_cast<float>(line.cells) / 32.0F);
      count(kDistance + line.kind(), t.sides[k] / longest, 1.0F);
      if (line.kind() != kMixed) continue;
      count(kRatio, static_cast<float>(line.filled) / static_cast<float>(line.cells), 1.0F);
    }
  }

  std::array<float, ShapeHistogram::kHistograms * ShapeHistogram::kBins> bins_{};
};

}  // namespace

ShapeHistogram::Pooled ShapeHistogram::pooled() const {
  Pooled result{};
  for (std::size_t k = 0; k < bins.size(); ++k) {
    result[k / kBins * kPooledBins + k % kBins * kPooledBins / kBins] += bins[k];
  }
  return result;
}

ShapeHistogram shapeHistogram(const std::vector<Point>& points,
                              const std::vector<std::uint32_t>& indices) {
  if (indices.size() < kMinPoints) return {};
  const std::vector<Eigen::Vector3f> cloud = normalised(points, indices);
  const SurfaceGrid grid(cloud);
  Generator generator(seedOf(cloud));
  std::vector<Triple> triples;
  triples.reserve(kTriples);
  for (std::size_t k = 0; k < kMaxAttempts && triples.size() < kTriples; ++k) {
    if (const auto triple = measure(cloud, grid, generator)) triples.push_back(*triple);
  }
  if (triples.size() < kTriples / 10) return {};
  return Histograms(triples).normalisedBins();
}

float distance(const ShapeHistogram::Pooled& a, const ShapeHistogram::Pooled& b) {
  float sum = 0.0F;
  for (std::size_t k = 0; k < a.size(); ++k) sum += std::abs(a[k] - b[k]);
  return sum;
}

}  // namespace segdf
