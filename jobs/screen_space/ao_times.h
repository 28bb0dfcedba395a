// How long SAO and its baseline take, pass by pass and radius by radius.
//
// Source   [McGuire12] table 3 (sizes of picture with their guard bands; its time "per visible
//          pixel" is per pixel shown), table 2 (traffic of both), figure 5 (sampling time against
//          radius with and without the pyramid).
// Beware   Times are of this machine: read the ratios, and `copies`, the time over that of
//          copying as many bytes in the same run.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/measured.h"
#include "jobs/screen_space/technique.h"
#include "reports/scene_report.h"

namespace plumb {

/// The sizes of the paper's table 3.
struct TimedSize {
    int width_px, height_px, guard_px;
};
inline constexpr TimedSize kPaperSizes[] = {
    {1280, 720, 128}, {1920, 1080, 192}, {1920, 1200, 192}, {2560, 1600, 256}};
inline constexpr TimedSize kFigure5Size = {2560, 1600, 256};

/// A configuration of SAO or of its baseline.
struct NamedSao {
    std::string name;
    SaoOptions options;
};

/// Each of them at each size, in turns.
std::vector<PassTimes> TimePasses(const Scene& scene, const Camera& camera,
                                  const RayCaster& caster, std::span<const NamedSao> saos,
                                  std::span<const TimedSize> sizes, int rounds,
                                  double copy_bytes_per_second, const Clock& clock,
                                  Monitor& monitor = SilentMonitor());

/// Sampling time of one picture against the radius, 0.1 to 2 m, s = 9; in turns at each radius.
std::vector<RadiusTime> TimeRadii(const Scene& scene, const Camera& camera,
                                  const TimedSize& size, int rounds, const Clock& clock,
                                  Monitor& monitor = SilentMonitor());

/// Bytes read and written a second by a copy of memory, all threads.
Measured CopyRate(int rounds, const Clock& clock);

}  // namespace plumb
