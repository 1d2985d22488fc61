// SPDX-License-Identifier: BSD-3-Clause
// Tells why an instance was kept or removed.
#include <filesystem>
#include <iostream>
#include <string>

#include "segdf/io/evidence_log.hpp"
#include "segdf/io/scan_source.hpp"

#include "run_app.hpp"

namespace {

struct Options {
  std::string result;
  std::uint32_t instance = 0;
};

std::string sentence(const segdf::EvidenceRow& row) {
  std::string votes = std::to_string(row.dynamic_votes) + " of " + std::to_string(row.looks) +
                      " looks saw through it, " + std::to_string(row.needed_votes) + " needed; " +
                      std::to_string(row.static_votes) + " found it again";
  if (row.reason == "no_evidence") return "no other scan saw enough of it: kept";
  if (row.reason == "association") return "literal mode, by neighbours and occupancy";
  if (row.reason == "long_look")
    return "one clear look saw through it, from long before or with few to compare; " + votes;
  if (row.reason == "departure")
    return "went on steadily to another place, and where it was is empty; " + votes;
  if (row.reason == "restored")
    return "was restored, since hardly another member of its track moves; " + votes;
  if (row.reason == "track") return "goes with its track, which moves; " + votes;
  if (row.reason == "split") return "split off " + std::to_string(row.parent) + ": this part moved";
  if (row.reason == "kept") return "split off " + std::to_string(row.parent) + ": this part stood";
  if (row.reason == "left") {
    return "all its points up to here, since it has left: later scans saw through its place";
  }
  if (row.reason == "consensus") return "goes, as in most scans around; " + votes;
  if (row.reason == "enclosed") return "lies inside a removed instance, and goes with it; " + votes;
  return votes;
}

void explain(const Options& options) {
  const auto rows =
      segdf::readEvidence(std::filesystem::path(options.result) / "evidence.csv", options.instance);
  if (rows.empty()) {
    throw segdf::IoError("no instance " + std::to_string(options.instance) + " in " +
                         options.result + "; instances.csv lists them");
  }
  for (const segdf::EvidenceRow& row : rows) {
    std::cout << "scan " << row.scan << ": instance " << row.instance << ' ' << row.verdict << ", "
              << row.object_class << ", " << row.points << " points at (" << row.center
              << ") m: " << sentence(row) << '\n';
    if (!row.free_looks.empty()) {
      std::cout << "  seen through (scan:seconds:points): " << row.free_looks << '\n';
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Tells why an instance was kept or removed, scan by scan.", "segdf_explain");
  Options options;
  app.add_option("--result", options.result, "folder that segdf_offline wrote")->required();
  app.add_option("--instance", options.instance, "id, as in instances.csv, map and labels")
      ->required();
  return segdf::apps::runApp(app, argc, argv, [&options] {
    explain(options);
    return static_cast<int>(segdf::apps::kOk);
  });
}
