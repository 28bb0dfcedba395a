// Cosine visibility V under a ceiling, path-traced with its interval, beside the closed form.
//
//       1 - V = 4 F,   F = a / (pi s) atan(a / s),   s = sqrt(1 + a^2),   a = 1/2
//
// F is the form factor from a point to a unit square 1 m above one of its corners, here for a
// quarter of the ceiling [Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3].
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "rays/embree/embree_caster.h"
#include "truth/open_sky.h"

int main() {
    // A floor of 1 m x 1 m (face 0) and the same square 1 m above it (face 1), +z up.
    plumb::Mesh mesh;
    for (const float z : {0.f, 1.f}) {
        mesh.vertices_m.insert(
            mesh.vertices_m.end(),
            {{-.5f, -.5f, z}, {.5f, -.5f, z}, {.5f, .5f, z}, {-.5f, .5f, z}});
    }
    mesh.quads = {{0, 1, 2, 3}, {4, 5, 6, 7}};
    const plumb::EmbreeCaster caster(mesh);

    // The middle of the floor is the middle of the diagonal of its first triangle.
    plumb::Receiver middle{.triangle = 0, .spread = false, .b_1 = 0.5, .b_2 = 0.5};
    plumb::OpenSkyOptions options;
    options.sampling.points = 4096;  // of each of 8 independent nets
    const plumb::Measured V = CountOpenSky(caster, mesh, std::vector{middle}, options).Of(0);

    const double a = 0.5, s = std::sqrt(1 + a * a);
    const double expected = 1 - 4 * a / (std::numbers::pi * s) * std::atan(a / s);
    std::printf("V = %.5f, 95 %% interval %.5f to %.5f; closed form %.5f\n", V.value,
                V.interval.low, V.interval.high, expected);
    return V.interval.low <= expected && expected <= V.interval.high ? 0 : 1;
}
