// What the border that is drawn but not shown buys: [McGuire12]'s guard band, from none to about
// a quarter of the picture's height.
//
// The picture as shipped with each width of border, near the frame, against the truth and against
// the widest border; and what drawing and sampling the larger picture costs.
//
// All that depends on a pixel's place in the drawn picture (the hash that turns its taps, its
// quad, its texels in the pyramid) is the same for all widths: the hash is shifted, and widths are
// whole texels of the coarsest level. So a pixel whose taps stay within the frame does not change.
#pragma once

#include <vector>

#include "core/run_context.h"
#include "jobs/screen_space/technique.h"
#include "jobs/truth/view_truth.h"
#include "reports/document.h"

namespace plumb {

/// None, and five more, each wider by whole texels of the coarsest level: by about a twentieth of
/// the height.
std::vector<int> GuardWidths(int height_px, const SaoOptions& options);

/// Table guard_bands: one row a width. `truth` must hold the falloff of `options`. `rounds` of every
/// timing.
doc::Section StudyGuardBand(const Scene& scene, const Camera& camera, const ViewTruth& truth,
                            const SaoOptions& options, int rounds, const RunContext& run);

}  // namespace plumb
