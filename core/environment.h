// Light from infinitely far away as a picture of all directions: latitude and longitude.
//
//       x_s = 1/2 + (atan2(w_x, w_y) - turn) / (2 pi)         column x_s W, repeated
//       y_s = acos(w_z) / pi                                  row y_s H, row 0 about the zenith
//       L(w) = bilinear in the four texels about (x_s W, y_s H)
//       mean = Sum_j (cos(pi j/H) - cos(pi (j+1)/H)) / 2  *  mean of row j
//
// The middle of the picture is seen along +y, turned by `turn` towards +x.
//
// Symbols  w direction, +z up; W, H size of the picture.
// Beware   `mean` takes every texel as a patch of its own; that of the bilinear L differs where
//          rows near the poles do.
#pragma once

#include "core/image.h"
#include "core/vec.h"

namespace plumb {

struct Environment {
    Image<Rgb> radiance;  ///< Linear, finite, >= 0. Empty = 1 in every direction.
    double turn_rad = 0;
};

/// L(w). w need not be a unit vector, but not 0.
Rgb RadianceFrom(const Environment& environment, const Vec3& w);

/// Over all directions.
Rgb MeanRadiance(const Environment& environment);

}  // namespace plumb
