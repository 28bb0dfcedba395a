// The formulas that a refit must beat: in print or in use, scored as they are, never fitted.
#pragma once

#include <vector>

#include "fit/model.h"

namespace plumb {

/// Plain alpha, plain V, [Mayaux18 eq. 12] with the published constants under every PoleGuard,
/// [Jimenez16]'s cubic fed V and fed alpha, the cavity. All of them predict E(rho).
std::vector<Formula> Baselines();

}  // namespace plumb
