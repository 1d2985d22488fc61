// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <diagnostic_updater/diagnostic_updater.h>

#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include "segdf/nodelets/ledger.hpp"

namespace segdf {

/// The counts on /diagnostics, once a second of wall time: "input" (do clouds with poses come?) and
/// "filter" (does it keep up?). WARN as long as something is missing or was lost in the last
/// second.
class Diagnostics {
 public:
  /// @param name of the node, with its leading slash @param ledger outlives this object
  Diagnostics(const ros::NodeHandle& node,
              const ros::NodeHandle& private_node,
              const std::string& name,
              const Ledger& ledger);

 private:
  void tick();
  void reportInput(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void reportFilter(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  const Ledger& ledger_;
  Counts before_;
  Counts now_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace segdf
