// What the filter of the z pyramid costs in error: [McGuire12] table 1, with numbers.
//
// SAO's A before any filter, once for each way to make the pyramid that its description names,
// against A without one (each tap reads the full-resolution depth) and against the truth.
#pragma once

#include "jobs/screen_space/technique.h"
#include "jobs/truth/view_truth.h"
#include "reports/document.h"

namespace plumb {

/// Table pyramids: one row a ZFilter, and first one without a pyramid. `truth` must hold the
/// falloff of `options`.
doc::Section StudyPyramid(const TechniqueInput& in, const ViewTruth& truth,
                          const SaoOptions& options);

}  // namespace plumb
