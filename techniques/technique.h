// A picture technique: a G-buffer in, A out, described as data and told pass by pass.
//
//       technique.description              what it is, with knobs and switches
//       technique.with(values)             its knobs turned
//       run(input, observer)               its passes, one after the other
//
// The caller holds the stopwatch: see screen_space/pass_observer.h.
//
// Symbols  A as in screen_space/: 1 = open.
#pragma once

#include <functional>
#include <vector>

#include "core/camera.h"
#include "core/description.h"
#include "core/falloff.h"
#include "core/scene.h"
#include "screen_space/gbuffer.h"
#include "screen_space/pass_observer.h"

namespace plumb {

class RayCaster;

/// What techniques may look at: all but ray tracing see the G-buffer alone.
struct TechniqueInput {
    const GBuffer& gbuffer;
    const Scene& scene;
    const Camera& camera;
    const RayCaster& caster;
};

/// A technique with its knobs turned.
struct TurnedTechnique {
    Falloff falloff = Falloff::kHard;  ///< The truth weighted so is what it means to compute.
    int samples = 0;                   ///< Depth lookups, or rays, a pixel.
    std::function<void(const TechniqueInput&, const PassObserver&)> run;
};

struct PictureTechnique {
    Description description;

    /// Turned to the values given, the rest as published. Throws Error, naming knob, value and
    /// rule.
    std::function<TurnedTechnique(const KnobValues&)> with;
};

/// All there are: those that techniques/CMakeLists.txt lists, in its order.
const std::vector<PictureTechnique>& AllTechniques();

/// Throws Error "WHERE = NAME, must be one of ..." if there is none of that name.
const PictureTechnique& FindTechnique(const std::string& name,
                                      const std::string& where = "technique");

}  // namespace plumb
