// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "segdf/segmentation/curved_voxels.hpp"

namespace segdf {

namespace detail {

/// Visits the run of voxels with first <= key <= last, searching from `from` on.
template <class Visit>
std::size_t visitRun(const std::vector<CurvedGrid::Key>& keys,
                     std::size_t from,
                     CurvedGrid::Key first,
                     CurvedGrid::Key last,
                     std::size_t query,
                     const Visit& visit) {
  while (from < keys.size() && keys[from] < first) ++from;
  for (std::size_t v = from; v < keys.size() && keys[v] <= last; ++v) visit(query, v);
  return from;
}

/// The part of the neighbourhood on the other side of the seam at azimuth 0.
template <class Visit>
void visitAcrossSeam(CurvedGrid::Key row,
                     std::size_t query,
                     int azimuth,
                     int reach,
                     int cells,
                     const std::vector<CurvedGrid::Key>& keys,
                     const Visit& visit) {
  const int turn = azimuth < reach ? cells : (azimuth >= cells - reach ? -cells : 0);
  if (turn == 0) return;
  const CurvedGrid::Key first = CurvedGrid::shifted(row, 0, 0, turn - reach);
  const CurvedGrid::Key last = CurvedGrid::shifted(row, 0, 0, turn + reach);
  const auto from = std::lower_bound(keys.begin(), keys.end(), first) - keys.begin();
  visitRun(keys, static_cast<std::size_t>(from), first, last, query, visit);
}

/// All neighbours of the queries in the row of cells `range` and `polar` away.
template <class Visit>
void visitRow(const std::vector<CurvedGrid::Key>& queries,
              const CurvedVoxels& voxels,
              const CurvedGrid& grid,
              int reach,
              int range,
              int polar,
              const Visit& visit) {
  // Queries ascend, so the run of candidates only moves forward.
  std::size_t from = 0;
  for (std::size_t q = 0; q < queries.size(); ++q) {
    const CurvedGrid::Key row = CurvedGrid::shifted(queries[q], range, polar, 0);
    from = visitRun(voxels.keys, from, CurvedGrid::shifted(row, 0, 0, -reach),
                    CurvedGrid::shifted(row, 0, 0, reach), q, visit);
    visitAcrossSeam(row, q, CurvedGrid::azimuthOf(queries[q]), reach, grid.azimuthCells(),
                    voxels.keys, visit);
  }
}

}  // namespace detail

template <class Visit>
void forEachNeighbour(const std::vector<CurvedGrid::Key>& queries,
                      const CurvedVoxels& voxels,
                      const CurvedGrid& grid,
                      int reach,
                      const Visit& visit) {
  for (int range = -reach; range <= reach; ++range) {
    for (int polar = -reach; polar <= reach; ++polar) {
      detail::visitRow(queries, voxels, grid, reach, range, polar, visit);
    }
  }
}

template <class Visit>
void forEachNeighbourPair(const CurvedVoxels& voxels,
                          const CurvedGrid& grid,
                          int reach,
                          const Visit& visit) {
  const auto upwards = [&visit](std::size_t a, std::size_t b) {
    if (a < b) visit(a, b);
  };
  // Rows before the voxel's own hold what has seen it already.
  for (int polar = 0; polar <= reach; ++polar) {
    detail::visitRow(voxels.keys, voxels, grid, reach, 0, polar, upwards);
  }
  for (int range = 1; range <= reach; ++range) {
    for (int polar = -reach; polar <= reach; ++polar) {
      detail::visitRow(voxels.keys, voxels, grid, reach, range, polar, upwards);
    }
  }
}

}  // namespace segdf
