// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "segdf/core/config.hpp"
#include "segdf/segmentation/intensity_fit.hpp"

namespace segdf {

/// Draws a fit as PNG: how bright the same surface is over range (left) and over the cosine of the
/// incidence angle (right), with the fitted model, a compensated sensor and formula (6) as lines.
/// Writes beside and renames. @param config gives r_ref, where the models are 1 @throws IoError
void writeIntensityPlot(const std::filesystem::path& file,
                        const IntensityFit& fit,
                        const IntensityConfig& config);

}  // namespace segdf
