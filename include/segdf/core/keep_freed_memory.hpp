// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace segdf {

/// Every scan takes megabytes and gives them back. Returned to the system, each page would have to
/// be handed out and cleared anew, which costs as much as half of the segmentation itself. Holds
/// for the whole process, so it is for its owner to call, at its start.
inline void keepFreedMemory() {
#ifdef __GLIBC__
  constexpr int kThreshold = 256 << 20;
  mallopt(M_MMAP_THRESHOLD, kThreshold);
  mallopt(M_TRIM_THRESHOLD, kThreshold);
#endif
}

}  // namespace segdf
