// The surfaces of a fit, each under a name of its own.
//
// A name is a key: in tables, in the plots' choices, and (jobs/write_results.h) in the files of
// the pictures. Maps that share one, as m1/wall.png and m2/wall.png do, are told apart by the
// folder that they lie in ("m1/wall", "m2/wall"), and by a number where that is not enough.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "jobs/light/surface.h"

namespace plumb {

/// LoadSurface of every name, their source.name made distinct, also as parts of file names.
std::vector<Surface> LoadSurfaces(std::span<const std::string> names,
                                  const SurfaceOptions& options = {});

}  // namespace plumb
