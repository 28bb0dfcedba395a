// How long SAO and its baseline take, pass by pass and radius by radius.
//
// Source   [McGuire12] tables 2 and 3 (sizes of picture with their guard bands), figure 5
//          (sampling time against radius with and without the pyramid).
// Beware   Times are of this machine: read the ratios, and `copies`, the time over that of
//          copying as many bytes in the same run.
#pragma once

#include <vector>

#include "jobs/screen_space/technique.h"
#include "reports/scene_report.h"

namespace plumb {

/// The sizes of the paper's table 2.
struct TimedSize {
    int width_px, height_px, guard_px;
};
inline constexpr TimedSize kPaperSizes[] = {
    {1280, 720, 128}, {1920, 1080, 192}, {1920, 1200, 192}, {2560, 1600, 256}};

/// SAO as in the supplement, and AlchemyAO, at the paper's sizes. `rounds` runs each.
std::vector<PassTimes> TimePasses(const Scene& scene, const Camera& camera,
                                  const RayCaster& caster, double radius_m, int rounds,
                                  double copy_bytes_per_second, const PassClock& clock,
                                  Monitor& monitor = SilentMonitor());

/// Sampling time of one picture against the radius, 0.1 to 2 m, s = 9.
std::vector<RadiusTime> TimeRadii(const Scene& scene, const Camera& camera,
                                  const TimedSize& size, int rounds, const PassClock& clock,
                                  Monitor& monitor = SilentMonitor());

/// Bytes a pixel that the passes read and write at least: every picture once, taps from the
/// cache.
double BytesPerPixel(const SaoOptions& options);

/// Bytes read and written a second by a copy of memory, all threads: the median of `rounds`.
double CopyBytesPerSecond(int rounds, const PassClock& clock);

}  // namespace plumb
