// What a path-traced truth says of itself: means, errors, why it stopped, what went wrong.
//
// Pure: the same result gives the same bytes. No time is in it, so that a run that was stopped
// and resumed reports the same as one that was not.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/document.h"

namespace plumb {

/// One image: its name, its mean and its errors over the pixels that show a surface.
struct TruthQuantity {
    std::string name;
    double mean = 0;
    double rms_error = 0;  ///< Root mean square of the pixels' standard errors.
    /// From the value to the ends of its 95 % interval, root mean square.
    double rms_below = 0, rms_above = 0;
};

struct TruthReport {
    std::string tool_version;
    std::string command;  ///< The command line that makes the truth again.
    std::string scene, scene_sha256;
    std::string camera;
    int width_px = 0, height_px = 0;
    std::uint64_t seed = 1;
    int nets = 0;            ///< R, replicates.
    std::int64_t spp = 0;    ///< Samples a pixel, of all nets.
    std::string stopped_by;  ///< "samples", "target error", "time" or "interruption".
    std::vector<TruthQuantity> quantities;
    std::int64_t pixels_seen = 0;          ///< That show a surface.
    std::int64_t seen_from_behind = 0;     ///< That show the back of a face.
    std::int64_t zero_area_triangles = 0;  ///< Kept out of ray casting.
    std::int64_t lost_walks = 0;
    std::vector<std::string> notes;
};

/// One section.
doc::Document DocumentOf(const TruthReport& report);

}  // namespace plumb
