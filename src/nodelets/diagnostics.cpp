// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/diagnostics.hpp"

namespace segdf {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

constexpr double kPeriod = 1.0;  // seconds

}  // namespace

Diagnostics::Diagnostics(const ros::NodeHandle& node,
                         const ros::NodeHandle& private_node,
                         const std::string& name,
                         const Ledger& ledger)
    : ledger_(ledger), updater_(node, private_node, name) {
  updater_.setHardwareID("none");
  updater_.add("input", [this](DiagnosticStatusWrapper& status) { reportInput(status); });
  updater_.add("filter", [this](DiagnosticStatusWrapper& status) { reportFilter(status); });
  timer_ = node.createWallTimer(ros::WallDuration(kPeriod),
                                [this](const ros::WallTimerEvent&) { tick(); });
}

void Diagnostics::tick() {
  before_ = now_;
  now_ = ledger_.counts();
  updater_.force_update();
}

void Diagnostics::reportInput(DiagnosticStatusWrapper& status) const {
  if (now_.pairs == before_.pairs && now_.scansWaiting() == 0) {
    status.summary(DiagnosticStatus::WARN, "no cloud with a pose in the last second");
  } else if (now_.unmatched > before_.unmatched || now_.lost > before_.lost) {
    status.summary(DiagnosticStatus::WARN, "clouds without pose, or lost on the way");
  } else {
    status.summary(DiagnosticStatus::OK, "clouds with poses come");
  }
  status.add("clouds received", now_.clouds);
  status.add("poses received", now_.poses);
  status.add("clouds waiting for a pose", now_.clouds_waiting);
  status.add("clouds without pose", now_.unmatched);
  status.add("clouds lost on the way", now_.lost);
  status.add("clouds with poses in the last second", now_.pairs - before_.pairs);
}

void Diagnostics::reportFilter(DiagnosticStatusWrapper& status) const {
  if (now_.dropped > before_.dropped) {
    status.summary(DiagnosticStatus::WARN, "too slow: scans are dropped");
  } else if (now_.unusable > before_.unusable) {
    status.summary(DiagnosticStatus::WARN, "scans that cannot be used");
  } else {
    status.summary(DiagnosticStatus::OK, "keeps up");
  }
  status.add("scans filtered", now_.processed);
  status.add("scans waiting", now_.scansWaiting());
  status.add("scans dropped", now_.dropped);
  status.add("scans unusable", now_.unusable);
  status.add("frames published", now_.frames);
  status.add("restarts: time went backwards", now_.time_resets);
  status.add("restarts: pose jumped", now_.jump_resets);
}

}  // namespace segdf
