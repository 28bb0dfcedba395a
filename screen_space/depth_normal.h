// Face normals out of depth alone, as a shader's derivatives give them.
//
//       n = normalize(dC/dy' x dC/dx')                              [McGuire12 eq. 4]
//
// The derivatives are differences across the aligned 2 x 2 quad of the pixel, in its own row and
// its own column (GLSL: dFdxFine, dFdyFine). With S = C / z = (s_x, s_y, 1), a = dz/dx', b =
// dz/dy' and p, q what a step in x', y' moves a point at the partner's depth,
//
//       dC/dy' x dC/dx' = -p q (-a/p, -b/q, 1 + a/p s_x + b/q s_y),         p > 0 > q
//
// Source   [McGuire12 eq. 4]. Rows run downwards, so that the order printed faces the viewer.
// Symbols  C point of the pixel in the camera's frame (m), (x', y') the pixel.
// Domain   Where a quad is cut by the border, or the partner is sky, the neighbour on the other
//          side is the partner. Where that fails too the normal is the direction to the eye.
// Beware   At the edge of an object the difference spans both surfaces and the normal is of
//          neither. G3D 10 gives A = 1 where |dC/dy' x dC/dx'| > 6e-5 z^2.
#pragma once

#include <cmath>

#include "core/image.h"
#include "core/vec.h"
#include "screen_space/view.h"

namespace plumb {

/// The step, +1, -1 or 0 (none), from i to its partner of n pixels: i ^ 1, or the other neighbour
/// if that is missing or sky. `z(i)` is the depth of pixel i of the row or column.
template <class Depth>
int StepToPartner(int i, int n, const Depth& z) {
    const int step = i % 2 == 0 ? 1 : -1;
    for (const int s : {step, -step}) {
        if (0 <= i + s && i + s < n && std::isfinite(z(i + s))) return s;
    }
    return 0;
}

struct DepthNormal {
    Vec3 n{0, 0, 1};  ///< Unit, towards the viewer.
    double area = 0;  ///< |dC/dy' x dC/dx'| / z_C^2; 0 where there was no partner.
};

/// Of a pixel that is not sky.
DepthNormal NormalFromDepth(const View& view, const Image<float>& z_m, int x, int y);

}  // namespace plumb
