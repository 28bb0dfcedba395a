// Error against run time: every technique at several settings, on one view.
//
// Settings: lookups or rays a pixel, half and twice the radius, half the resolution (each pixel of
// its picture shown four times; time without that), filters, pyramid, packing and quads on and
// off; each changes one thing of the technique as its user chose it. Every point is scored against V
// within r. The Pareto front names the settings that no other one beats in both time and error.
#pragma once

#include <span>

#include "core/run_context.h"
#include "jobs/screen_space/chosen_technique.h"
#include "jobs/screen_space/find_closest.h"
#include "jobs/truth/view_truth.h"
#include "reports/document.h"

namespace plumb {

struct Sweep {
    doc::Section section;  ///< Tables pareto_front and sweep.
    Closest cheapest;  ///< The fastest within `tolerance` of the least RMSE; ties on the front.
};

/// `rounds` of every timing; `tolerance` as a share of the least RMSE.
Sweep SweepTechniques(const TechniqueInput& in, const ViewTruth& truth,
                      std::span<const ChosenTechnique> techniques, int rounds, double tolerance,
                      const RunContext& run);

}  // namespace plumb
