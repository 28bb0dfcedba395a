// The path-traced truth of one view, with a standard error for every pixel.
//
// Every net is taken in passes that double its points; after each, the errors are known, the
// state is kept, and the stop rules are asked. So a run that was stopped, or killed, goes on to
// the same bits as one that was not.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/run_context.h"
#include "io/image_io.h"
#include "jobs/truth/load_scene.h"
#include "reports/truth_report.h"
#include "truth/near_visibility.h"
#include "truth/sky.h"

namespace plumb {

struct TruthJob {
    std::string camera;               ///< Empty = the scene's first.
    int width_px = 0, height_px = 0;  ///< 0 = the camera's own. [0, 65536]
    bool V = true;                    ///< The cosine visibility; bounces bring it too.
    bool alpha = true;                ///< Also the uniform visibility.
    int bounces = 0;                  ///< K: also E_1 ... E_K; 0 = V only. [0, 100]
    std::vector<double> albedos;      ///< With bounces: also E(rho). Each in [0, 1].
    double reach_m = 0;               ///< Also the visibility within this reach; 0 = not. >= 0
    Falloff falloff = Falloff::kHard;
    bool irradiance = false;  ///< Also the light with the scene's own albedos, sky and lights.
    bool beauty = false;      ///< Also the shading model, averaged over each pixel.
    std::uint64_t seed = 1;

    // Whichever comes first stops the run; the points of all 8 nets are counted.
    int max_spp = 512;  ///< A power of two times 8. [64, 2^31]
    /// Root mean square standard error of V; without V of the worst colour of irradiance, or
    /// else beauty; or else of what there is. 0 = no such rule. >= 0
    double target_error = 0;
    double max_seconds = std::numeric_limits<double>::infinity();  ///< > 0
    bool resume = false;  ///< There must be a state in the cache to go on from.
    bool use_cache =
        true;  ///< Keep states, and go on from what is kept (jobs/truth/truth_cache.h).
    std::filesystem::path cache;  ///< Empty = the folder "cache" in that of the results.
};

/// Throws Error, naming field, value and rule.
void Validate(const TruthJob& job);

struct TruthResult {
    TruthReport report;
    Lost lost;
    double seconds = 0;
    std::vector<NamedChannel> channels;  ///< Of truth.exr.
    doc::Document document;              ///< Of the report, with pictures.
    std::filesystem::path page;
    bool interrupted = false;
};

/// Measures and writes truth.exr, truth.html, truth.json, truth.csv and pictures into the folder of
/// the run. An interruption after
/// the first pass writes what there is; before it, Interrupted is thrown.
TruthResult MeasureTruth(const LoadedScene& loaded, const TruthJob& job, const RunContext& run);

}  // namespace plumb
