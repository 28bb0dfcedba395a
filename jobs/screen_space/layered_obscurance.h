// SAO's estimator on full geometry: what it would say if the depth buffer hid nothing.
//
//       A = estimator( max over layers l of f(Q_il - C),  i = 1 ... s )
//
// At each tap the line of sight through it is followed through the whole scene from the near plane
// on, in front of and behind what is seen, and of all points Q_il that it meets the one that
// occludes most counts.
// The difference to SamplePass with as many taps is what seeing one layer of depth costs.
//
// Symbols  as in screen_space/sao/sao.h; l counts the layers along one line of sight.
// Cost     s rays a pixel and layer: only every `stride_px`-th pixel of every such row is made.
#pragma once

#include "jobs/screen_space/technique.h"
#include "screen_space/sao/sao_passes.h"

namespace plumb {

struct LayeredOptions {
    int stride_px = 4;     ///< [1, 4096]
    int most_layers = 64;  ///< Followed along one line of sight. [1, 4096]
};

/// A of the shown size; NaN where it was not made, 1 for the sky. Lines of sight that leave the
/// picture count too.
Image<float> LayeredObscurance(const TechniqueInput& in, const SaoOptions& options,
                               const LayeredOptions& layered,
                               Monitor& monitor = SilentMonitor());

}  // namespace plumb
