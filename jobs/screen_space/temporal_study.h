// How much techniques flicker while the camera moves by parts of a pixel.
//
// The camera moves sideways and up by the 16 points of a net within a pixel of the picture's
// middle; every frame has a truth with a seed of its own (score/temporal.h).
#pragma once

#include <span>

#include "core/run_context.h"
#include "jobs/screen_space/chosen_technique.h"
#include "reports/document.h"

namespace plumb {

struct TemporalOptions {
    int frames = 16;  ///< [2, 1024]
    int width_px = 480, height_px = 270, guard_px = 48;
    int spp = 64;           ///< Of every frame's truth: a power of two.
    double radius_m = 1.5;  ///< Of the truth.
    std::uint64_t seed = 1;
};

/// Table flicker: one row a technique.
doc::Section StudyFlicker(const Scene& scene, const Camera& camera, const RayCaster& caster,
                          std::span<const ChosenTechnique> techniques,
                          const TemporalOptions& options, const RunContext& run);

}  // namespace plumb
