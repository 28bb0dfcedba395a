// The filter passes as knobs, and the one filter that every technique but SAO and AlchemyAO gets.
//
// It is that of SAO's supplement on unpacked numbers, so that none wins by a better filter.
#pragma once

#include "screen_space/sao/sao_passes.h"
#include "techniques/knobs.h"

namespace plumb {

/// Switches and constants of the passes after sampling, quads apart.
BoundKnobs<SaoOptions> FilterKnobs();

/// Supplement 2012, unpacked, without quads.
SaoOptions CommonFilter();

/// A technique that samples in one pass and is then filtered.
template <class Sampling>
struct Filtered {
    Sampling sampling;
    SaoOptions filter = CommonFilter();
};

template <class Sampling>
BoundKnobs<Filtered<Sampling>> FilteredKnobs(const BoundKnobs<Sampling>& knobs) {
    using Options = Filtered<Sampling>;
    return Together(Within<Options>(
                        knobs, [](auto& o) -> auto& { return o.sampling; }),
                    Within<Options>(
                        FilterKnobs(), [](auto& o) -> auto& { return o.filter; }));
}

/// Tells "sample", then the filter's passes if one is on. `A` is needed within FilteredRect.
void RunFilter(const GBuffer& gbuffer, const SaoOptions& filter, Image<float> A,
               const PassObserver& observer);

}  // namespace plumb
