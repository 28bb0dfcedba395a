// The truth of one view in memory: what screen-space pictures are scored against.
//
// V, and the visibility within a radius by several falloffs; every pixel with the standard error
// of its nets, the plain one: its square is unbiased, as scores need it.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "core/image.h"
#include "core/monitor.h"
#include "core/scene.h"
#include "jobs/truth/truth_nets.h"
#include "truth/near_visibility.h"
#include "truth/pixels.h"
#include "truth/sky.h"

namespace plumb {

struct ViewTruthOptions {
    double radius_m = 1.5;   ///< r of the near visibilities. (0, infinity)
    int spp = 256;           ///< Rays a pixel: a power of two. [16, 2^20]
    std::uint64_t seed = 1;  ///< Of the nets.
    bool far = true;         ///< Also V, of all the scene.
};

/// Throws Error, naming field, value and rule.
void Validate(const ViewTruthOptions& options);
void RequireSpp(const std::string& field, int spp);

/// 1 with no error where the sky is seen.
struct TruthImage {
    Image<float> value, standard_error;
};

struct ViewTruth {
    PixelGeometry pixels;
    TruthImage V;                        ///< Empty without `far`.
    std::map<Falloff, TruthImage> near;  ///< By each falloff asked for.
    Lost lost;
};

ViewTruth MeasureViewTruth(const RayCaster& caster, const Scene& scene, const Camera& camera,
                           std::span<const Falloff> falloffs, const ViewTruthOptions& options,
                           Monitor& monitor = SilentMonitor());

}  // namespace plumb
