// Where SAO's error comes from: one approximation switched on at a time, from the ideal to the
// shipped.
//
//       ideal       visibility weighted by the technique's falloff, path-traced
//       estimator   its integral over all layers of depth
//       one layer   the nearest surface only, a wide border
//       border      that of the shipped picture
//       normals, s taps, then the switches of SAO that are on: pyramid, quads, packing, the filter
//       along x and along y
//
// Every row is scored against V within r, what a user wants, and beside it against that weighted by
// the falloff, what the technique means to compute. So the first row is what the falloff costs, each
// other adds what its step costs, and the last is the shipped technique. All rows count the same
// pixels, those of every `stride_px`-th column and row, because integrals are dear: there `many_taps`
// stand for the integral. `rms_change` is how far a step moves the picture itself.
//
// What the border saves is not a step on the way: `no_border` is the last row without one.
//
// Beware   The ideal and V within r come of the same rays, so that most of their noise cancels in
//          their difference: nothing is taken off in the first row.
#pragma once

#include "core/run_context.h"
#include "jobs/screen_space/technique.h"
#include "jobs/truth/view_truth.h"
#include "reports/document.h"

namespace plumb {

struct BudgetOptions {
    int many_taps = 4096;            ///< In place of an integral over the disc. [1, 4096]
    int stride_px = 8;               ///< Of the pixels scored. [1, 4096]
    int guard_px = 96;               ///< As shipped. >= 0
    double wide_guard_share = 0.25;  ///< Of the picture's height, in place of no border. [0, 1]
    int rounds = 5;                  ///< Of every timing. [1, 1000]
};

/// Tables budget, one row a step, and no_border; the section's own columns of a score are those
/// against V within r, own_ against the weighted. `technique` is its name for people.
doc::Section MakeErrorBudget(const std::string& technique, const SaoOptions& shipped,
                             const Scene& scene, const Camera& camera, const RayCaster& caster,
                             const ViewTruth& truth, const BudgetOptions& options,
                             const RunContext& run);

}  // namespace plumb
