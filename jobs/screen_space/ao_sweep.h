// Error against run time: every technique at several settings, on one view.
//
// Settings: lookups or rays a pixel, half and twice the radius, half the resolution (each pixel of
// its picture shown four times; time without that), filters, pyramid, packing and quads on and
// off; each changes one thing of the technique as its user chose it. Every point is scored against V
// within r. The Pareto front names the settings that no other one beats in both time and error.
#pragma once

#include <span>
#include <vector>

#include "jobs/screen_space/chosen_technique.h"
#include "jobs/truth/view_truth.h"
#include "reports/scene_report.h"

namespace plumb {

struct Sweep {
    std::vector<SweepPoint> points;
    Closest cheapest;  ///< The fastest within `tolerance` of the least RMSE; ties on the front.
};

/// `rounds` of every timing; `tolerance` as a share of the least RMSE.
Sweep SweepTechniques(const TechniqueInput& in, const ViewTruth& truth,
                      std::span<const ChosenTechnique> techniques, int rounds, double tolerance,
                      const Clock& clock, Monitor& monitor = SilentMonitor());

}  // namespace plumb
