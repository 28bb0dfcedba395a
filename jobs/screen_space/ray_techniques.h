// Ray tracing with a handful of rays a pixel, as a family of techniques.
#pragma once

#include <vector>

#include "techniques/technique.h"

namespace plumb {

/// rays-1, rays-2, rays-4, rays-8.
std::vector<PictureTechnique> RayTechniques();

}  // namespace plumb
