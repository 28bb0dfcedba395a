// What the border that is drawn but not shown buys: [McGuire12]'s guard band, from none to a
// quarter of the picture's height.
//
// The picture as shipped with each width of border, near the frame, against the truth and against
// the widest border; and what drawing and sampling the larger picture costs.
#pragma once

#include <vector>

#include "jobs/screen_space/technique.h"
#include "jobs/truth/view_truth.h"
#include "reports/scene_report.h"

namespace plumb {

/// One row a share of 0, 5, 10, 15, 20 and 25 %. `truth` must hold the falloff of `options`.
std::vector<GuardRow> StudyGuardBand(const Scene& scene, const Camera& camera,
                                     const ViewTruth& truth, const SaoOptions& options,
                                     const PassClock& clock);

}  // namespace plumb
