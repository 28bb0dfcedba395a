// The name of E(rho) where names may have no dot: channels of images.
//
//       "E_rho" + the shortest digits of rho, "p" for the point, "m" for the minus of an exponent
//
// so that 0.5 is E_rho0p5, 1 is E_rho1 and 1e-05 is E_rho1em05. Readers of EXR take what stands
// before a dot in a channel's name for a layer's name; here a dot is left to what it means
// there, as in E_rho0p5.error.
//
// Symbols  E(rho), rho as in core/conventions.h.
#pragma once

#include <string>

#include "core/visibility.h"

namespace plumb {

/// Different for every two albedos.
std::string TotalName(Albedo rho);

}  // namespace plumb
