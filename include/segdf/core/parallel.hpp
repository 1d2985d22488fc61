// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <exception>

namespace segdf {

/// Calls `body(i)` for i in [0, n) on up to `threads` threads. Each i must write only to its own
/// slot, so that the result does not depend on the number of threads. The first exception (in the
/// order of arrival) is thrown again after the loop.
template <class Body>
void parallelFor(std::size_t n, int threads, const Body& body) {
  std::exception_ptr failure;
  const auto count = static_cast<std::ptrdiff_t>(n);
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads) if (threads > 1)
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    try {
      body(static_cast<std::size_t>(i));
    } catch (...) {
#pragma omp critical(segdf_parallel_failure)
      if (!failure) failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
}

/// As parallelFor, for many cheap items: `body(begin, end)` gets blocks of `grain` items.
template <class Body>
void parallelBlocks(std::size_t n, std::size_t grain, int threads, const Body& body) {
  const std::size_t blocks = (n + grain - 1) / grain;
  parallelFor(blocks, threads, [&](std::size_t block) {
    const std::size_t begin = block * grain;
    body(begin, begin + grain < n ? begin + grain : n);
  });
}

}  // namespace segdf
