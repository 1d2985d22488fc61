// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/instance_csv.hpp"

#include <iomanip>
#include <sstream>

#include "segdf/io/atomic_file.hpp"

namespace segdf {

void writeInstanceCsv(const std::filesystem::path& file,
                      const std::vector<InstanceRecord>& records) {
  std::ostringstream csv;
  csv << "id,parent,class,frames,points,dynamic_points,length,width,height,verdict,static_votes,"
         "dynamic_votes,fused,reason\n"
      << std::fixed << std::setprecision(2);
  for (const InstanceRecord& r : records) {
    csv << r.id << ',' << r.parent << ',' << toString(r.object_class) << ',' << r.frames << ','
        << r.points << ',' << r.dynamic_points << ',' << r.size.x() << ',' << r.size.y() << ','
        << r.size.z() << ',' << (r.isDynamic() ? "dynamic" : "static") << ',' << r.static_votes
        << ',' << r.dynamic_votes << ',' << (r.fused ? 1 : 0) << ',' << toString(r.reason())
        << '\n';
  }
  writeWhole(file, csv.str());
}

}  // namespace segdf
