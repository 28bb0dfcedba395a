// SAO and AlchemyAO as techniques: one estimator, four sets of constants.
#pragma once

#include "core/falloff.h"
#include "screen_space/sao/sao_passes.h"
#include "techniques/knobs.h"

namespace plumb {

/// Every constant of an SaoOptions.
BoundKnobs<SaoOptions> SaoKnobs();

/// The one of that name. Throws Error if there is none.
BoundKnob<SaoOptions> SaoKnob(const std::string& name);

/// The falloff of an estimator; its own bias and divisor left out.
Falloff FalloffOf(SaoFalloffKind kind);

}  // namespace plumb
