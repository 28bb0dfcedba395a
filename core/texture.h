// A picture wrapped around a surface.
//
//       albedo(u, v) = bilinear in the four texels whose centres surround (u W, (1 - v) H)
//
// repeated in both directions. Row 0 is the top of the picture, v = 1.
#pragma once

#include <string>

#include "core/image.h"
#include "core/vec.h"

namespace plumb {

struct Texture {
    std::string name;
    Image<Rgb> albedo;     ///< Linear. [0, 1]. At least 1 x 1.
    Image<float> opacity;  ///< [0, 1], of the same size; empty = opaque everywhere.
};

}  // namespace plumb
