// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "segdf/dynamics/frame.hpp"

namespace segdf {

/// A frame has been judged: notes what its dynamic instances take up, and lets it and the
/// kFramesAround judged ones before it learn that from each other (KeyFrame::swept). Nothing that
/// stands can be where something moves a moment later or moved a moment ago: so the far side of a
/// car that drives off, a few points in no cluster, is known.
/// @param position of the frame in the window
void exchangeSweptVolumes(const Window& window, std::size_t position);

}  // namespace segdf
