// The path-traced truth of every triangle of a scene, over its whole area, with standard errors.
//
//       V, alpha, E_1 ... E_K as jobs/truth/truth.h measures them at pixels, here as means over
//       a triangle, on the side from which its corners run counter-clockwise
//
// Cost     spp rays a triangle and quantity; spp walks if there are bounces.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/monitor.h"
#include "jobs/truth/load_scene.h"

namespace plumb {

struct FacetTruthJob {
    int spp = 256;      ///< Points a triangle: a power of two. [16, 2^31)
    int bounces = 0;    ///< K: also E_1 ... E_K. [0, 100]
    bool alpha = true;  ///< Also the uniform visibility.
    std::uint64_t seed = 1;
};

/// Throws Error, naming field, value and rule.
void Validate(const FacetTruthJob& job);

struct FacetTruthResult {
    std::filesystem::path csv;
    std::int64_t triangles = 0;  ///< Measured.
    std::int64_t zero_area = 0;  ///< Left out.
    std::int64_t lost = 0;       ///< Rays and walks.
    double mean_V = 0;           ///< By area.
    double rms_error_V = 0;      ///< Root mean square standard error of the triangles' V.
};

/// Writes facets.csv into `folder`: triangle, its area and unit normal, then each quantity X, its
/// standard error and the ends of its 95 % interval (X, X_error, X_low, X_high). Triangle 2 f is (a, b, d) of face f, 2 f + 1 is (c, d, b).
FacetTruthResult MeasureFacetTruth(const LoadedScene& loaded, const FacetTruthJob& job,
                                   const std::filesystem::path& folder,
                                   Monitor& monitor = SilentMonitor());

}  // namespace plumb
