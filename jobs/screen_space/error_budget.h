// Where SAO's error comes from: one approximation switched on at a time, from the ideal to the
// shipped.
//
//       visibility weighted by the falloff, path-traced          the ideal
//       the estimator on full geometry, every layer of depth     as many taps as the next
//       one layer of depth, a wide border, many taps
//       the border of the shipped picture; then none
//       s taps
//       the z pyramid
//       2 x 2 quads;  A and z in RGB8;  the filter along x, along y
//
// Each row is scored against V within r, weighted by the technique's own falloff, over the same
// pixels: those of every `stride`-th column and row, because many taps and all layers are dear.
// `rms_change` is how far a step moves the picture itself, whatever the truth.
#pragma once

#include <vector>

#include "jobs/screen_space/technique.h"
#include "jobs/truth/view_truth.h"
#include "reports/scene_report.h"

namespace plumb {

struct BudgetOptions {
    int many_taps = 1024;            ///< In place of an integral over the disc. [1, 4096]
    int stride_px = 4;               ///< Of the pixels scored. [1, 4096]
    int guard_px = 96;               ///< As shipped. >= 0
    double wide_guard_share = 0.25;  ///< Of the picture's height, in place of no border. [0, 1]
};

std::vector<BudgetRow> MakeErrorBudget(const SaoOptions& shipped, const Scene& scene,
                                       const Camera& camera, const RayCaster& caster,
                                       const ViewTruth& truth, const BudgetOptions& options,
                                       const PassClock& clock,
                                       Monitor& monitor = SilentMonitor());

}  // namespace plumb
