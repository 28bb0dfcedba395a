// Error against run time: every technique at several settings, on one view.
//
// Settings: lookups or rays a pixel, half and twice the radius, half the resolution (each pixel of
// its picture shown four times; time without that), filters, pyramid, packing and quads on and
// off. Every point is scored against V within r. The Pareto front names the settings that
// no other one beats in both time and error.
#pragma once

#include <vector>

#include "jobs/screen_space/technique.h"
#include "jobs/truth/view_truth.h"
#include "reports/scene_report.h"

namespace plumb {

struct SweepOptions {
    double radius_m = 1.5;
    int rounds = 3;  ///< Of every timing; medians count. [1, 1000]
};

std::vector<SweepPoint> SweepTechniques(const TechniqueInput& in, const ViewTruth& truth,
                                        const std::vector<std::string>& techniques,
                                        const SweepOptions& options, const PassClock& clock,
                                        Monitor& monitor = SilentMonitor());

/// The passes of a technique run `rounds` times after a first run that does not count: the
/// pictures of the last, the median seconds of each pass.
std::vector<Pass> Timed(const Technique& technique, const TechniqueInput& in, int rounds,
                        const PassClock& clock);

}  // namespace plumb
