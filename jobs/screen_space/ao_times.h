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

#include "core/run_context.h"
#include "jobs/screen_space/chosen_technique.h"
#include "jobs/screen_space/time_techniques.h"
#include "reports/document.h"

namespace plumb {

/// The sizes of the paper's table 3.
struct TimedSize {
    int width_px, height_px, guard_px;
};
inline constexpr TimedSize kPaperSizes[] = {
    {1280, 720, 128}, {1920, 1080, 192}, {1920, 1200, 192}, {2560, 1600, 256}};
inline constexpr TimedSize kFigure5Size = {2560, 1600, 256};

Camera SizedAs(Camera camera, const TimedSize& size);

/// "1280 x 720 + 128"
std::string TextOf(const TimedSize& size);

/// Techniques of SAO's family at each size, in turns: tables times, and time_passes with the traffic
/// of each pass.
doc::Section TimePasses(const Scene& scene, const Camera& camera, const RayCaster& caster,
                        std::span<const ChosenTechnique> saos, std::span<const TimedSize> sizes,
                        int rounds, double copy_bytes_per_second, const RunContext& run);

/// Table radii: sampling time of one picture against the radius, 0.1 to 2 m, s = 9; in turns at each
/// radius.
doc::Section TimeRadii(const Scene& scene, const Camera& camera, const TimedSize& size,
                       int rounds, const RunContext& run);

}  // namespace plumb
