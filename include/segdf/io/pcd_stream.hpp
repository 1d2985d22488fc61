// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "segdf/io/atomic_file.hpp"
#include "segdf/mapping/map_point.hpp"

namespace segdf {

/// Binary PCD file of map points (fields x y z intensity label instance) that is written point by
/// point, so that a map of any size needs no memory. Appears under its name on finish().
class PcdStream {
 public:
  /// @throws IoError when the file cannot be created
  explicit PcdStream(const std::filesystem::path& file);

  /// @throws IoError when the disk is full
  void add(const std::vector<MapPoint>& points);
  std::size_t size() const { return count_; }
  /// Writes the count and renames the file into place. After an add() that failed, the file holds
  /// the points of those that did not. @throws IoError
  void finish();

 private:
  std::filesystem::path path_;
  AtomicFile file_;
  std::size_t count_ = 0;
};

/// A point to be looked at.
struct ColouredMapPoint {
  MapPoint point;
  std::uint32_t rgb = 0;  ///< 0x00RRGGBB
};

/// Binary PCD with the fields x y z intensity label instance rgb, the last as viewers want it: bit
/// for bit in a float. Appears whole or not at all. @throws IoError
void writeColouredPcd(const std::filesystem::path& file,
                      const std::vector<ColouredMapPoint>& points);

/// Calls `visit` for every point of a file that PcdStream wrote, one block at a time.
/// @throws IoError when it is no such file or ends early
void forEachPoint(const std::filesystem::path& file,
                  const std::function<void(const MapPoint&)>& visit);

}  // namespace segdf
