// What the filter of the z pyramid costs in error: [McGuire12] table 1, with numbers.
//
// SAO's A before any filter, once for each way to make the pyramid, against A without one (each
// tap reads the full-resolution depth) and against the truth.
#pragma once

#include <vector>

#include "jobs/screen_space/technique.h"
#include "jobs/truth/view_truth.h"
#include "reports/scene_report.h"

namespace plumb {

/// One row a ZFilter, and first one without a pyramid. `truth` must hold the falloff of `options`.
std::vector<PyramidRow> StudyPyramid(const TechniqueInput& in, const ViewTruth& truth,
                                     const SaoOptions& options);

}  // namespace plumb
