// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/evidence_log.hpp"

#include <fstream>
#include <iomanip>
#include <sstream>

#include "segdf/io/scan_source.hpp"

namespace segdf {

namespace {

constexpr const char* kHeader =
    "scan,instance,parent,verdict,reason,class,points,looks,dynamic_votes,static_votes,"
    "needed_votes,center,free_looks";
constexpr std::size_t kColumns = 13;
constexpr std::uint32_t kListed = 10;  // a look that saw through more than 1 in this many points

void writeRow(std::size_t scan, const InstanceObservation& seen, std::ostream& out) {
  out << scan << ',' << seen.id << ',' << seen.parent << ','
      << (seen.dynamic ? "dynamic" : "static") << ',' << toString(seen.reason) << ','
      << toString(seen.object_class) << ',' << seen.points << ',' << seen.looks.size() << ','
      << seen.dynamic_votes << ',' << seen.static_votes << ',' << seen.needed_votes << ','
      << seen.center.x() << ' ' << seen.center.y() << ' ' << seen.center.z() << ',';
  const char* separator = "";
  for (const Look& look : seen.looks) {
    if (kListed * look.free <= look.seen) continue;
    out << separator << look.scan << ':' << look.seconds << ':' << look.free << '/' << look.seen;
    separator = " ";
  }
  out << '\n';
}

/// One row for all the scans in which it stood: under the last of them, with the points of all.
void writeRow(const Revocation& revocation, std::ostream& out) {
  InstanceObservation seen;
  seen.id = revocation.id;
  seen.object_class = revocation.object_class;
  seen.dynamic = true;
  seen.points = static_cast<std::uint32_t>(revocation.points);
  seen.reason = Reason::kLeft;
  seen.center = revocation.center;
  writeRow(revocation.last, seen, out);
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells(1);
  for (char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

EvidenceRow rowOf(const std::vector<std::string>& cells) {
  const auto number = [&cells](std::size_t k) { return std::stoul(cells[k]); };
  EvidenceRow row;
  row.scan = number(0);
  row.instance = static_cast<std::uint32_t>(number(1));
  row.parent = static_cast<std::uint32_t>(number(2));
  row.verdict = cells[3];
  row.reason = cells[4];
  row.object_class = cells[5];
  row.points = number(6);
  row.looks = number(7);
  row.dynamic_votes = number(8);
  row.static_votes = number(9);
  row.needed_votes = number(10);
  row.center = cells[11];
  row.free_looks = cells[12];
  return row;
}

}  // namespace

EvidenceLog::EvidenceLog(const std::filesystem::path& file) : file_(file) {
  file_.write(std::string(kHeader) + "\n");
}

void EvidenceLog::add(const FrameResult& frame) {
  std::ostringstream rows;
  rows << std::fixed << std::setprecision(1);
  for (const Revocation& revocation : frame.revoked) writeRow(revocation, rows);
  for (const InstanceObservation& seen : frame.instances) writeRow(frame.index, seen, rows);
  file_.write(rows.str());
}

std::vector<EvidenceRow> readEvidence(const std::filesystem::path& file, std::uint32_t instance) {
  std::ifstream in(file);
  std::string line;
  if (!in) throw IoError("cannot read " + file.string() + "; is it a result of segdf_offline?");
  if (!std::getline(in, line) || line != kHeader) {
    throw IoError(file.string() + " has not the columns of evidence.csv; filter the drive again");
  }
  std::vector<EvidenceRow> rows;
  for (std::size_t number = 2; std::getline(in, line); ++number) {
    const std::vector<std::string> cells = cellsOf(line);
    if (cells.size() != kColumns) {
      throw IoError(file.string() + ", line " + std::to_string(number) + ": " +
                    std::to_string(cells.size()) + " columns instead of " +
                    std::to_string(kColumns));
    }
    const EvidenceRow row = rowOf(cells);
    if (row.instance == instance || row.parent == instance) rows.push_back(row);
  }
  return rows;
}

}  // namespace segdf
