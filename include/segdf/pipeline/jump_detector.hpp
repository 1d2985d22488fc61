// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "segdf/core/scan.hpp"

namespace segdf {

/// Finds poses that the motion before cannot explain: the corrections of a loop closure. A pose is
/// expected where the speed between the two before leads; what strong braking or turning adds,
/// 10 m/s^2 over the time passed, is no jump. Turns alone are not looked at.
class JumpDetector {
 public:
  /// @param max_jump metres beyond what is explained; 0 finds nothing
  explicit JumpDetector(double max_jump) : max_jump_(max_jump) {}

  /// Takes the next scan; one without a valid pose or later stamp is passed over.
  /// @return true if it lies behind a jump. The scan after that is never one itself.
  bool jumps(const Scan& scan);

 private:
  struct Place {
    std::int64_t stamp_ns = 0;
    Eigen::Vector3d position;
  };

  bool isUnexplained(const Place& now) const;

  double max_jump_;
  std::optional<Place> before_;
  std::optional<Place> last_;
};

}  // namespace segdf
