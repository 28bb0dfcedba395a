// Ball occlusion: how much of a ball about the receiver the depth buffer shows empty.
//
//       A = share of the points C + r s_i that lie before the depth of their pixel,  i = 1 ... 2 N
//
// s_i are N points of the unit ball and their mirror images -s_i, so that a plane takes exactly half
// of them.
//
// Source   [Mittring07] M. Mittring, Finding Next Gen: CryEngine 2, SIGGRAPH courses, 2007.
// Symbols  C receiver (m, the camera's frame), r radius (m), N pairs of points.
// Beware   An open plane has A = 1/2, not 1: half of every ball is below ground. Points beyond the
//          picture are left out. The sky has A = 1.
// Cost     2 N depth lookups a pixel.
#pragma once

#include <cmath>
#include <vector>

#include "core/conventions.h"
#include "core/parallel.h"
#include "core/sobol.h"
#include "screen_space/gbuffer.h"
#include "screen_space/pixel_rect.h"

namespace plumb {

struct BallOptions {
    double radius_m = 1;  ///< r. [1e-4, 1e7]
    int pairs = 8;        ///< N. [1, 2048]
};

/// s_1 ... s_N: even in the ball's volume.
inline std::vector<Vec3> PointsOfBall(int pairs) {
    std::vector<Vec3> points;
    for (int i = 0; i < pairs; ++i) {
        const Vec2 u = SobolOwenPair(std::uint32_t(i), 0, 1),
                   v = SobolOwenPair(std::uint32_t(i), 1, 1);
        const double z = 2 * u.x() - 1, phi = 2 * kPi * u.y(), across = std::sqrt(1 - z * z);
        points.push_back(std::cbrt(v.x()) *
                         Vec3(across * std::cos(phi), across * std::sin(phi), z));
    }
    return points;
}

/// A of the drawn size: computed within `where`, 1 elsewhere.
inline Image<float> BallOcclusion(const GBuffer& gbuffer, const BallOptions& options,
                                  const PixelRect& where) {
    const View& view = gbuffer.view;
    const PixelRect drawn = Drawn(view);
    const std::vector<Vec3> points = PointsOfBall(options.pairs);
    Image<float> A(view.DrawnWidth(), view.DrawnHeight(), 1);
    ParallelFor(where.Height(), 4, [&](std::int64_t begin, std::int64_t end) {
        for (int y = where.y0 + int(begin); y < where.y0 + int(end); ++y) {
            for (int x = where.x0; x < where.x1; ++x) {
                if (gbuffer.triangle(x, y) == GBuffer::kSky) continue;
                const Vec3 C = view.Point(x + 0.5, y + 0.5, gbuffer.z_m(x, y));
                int open = 0, met = 0;
                for (const Vec3& s : points) {
                    for (const double side : {1.0, -1.0}) {
                        const Vec3 P = C + side * options.radius_m * s;
                        if (P.z() >= 0) continue;  // behind the eye
                        const Vec2 at = view.Project(P);
                        const int i = int(std::floor(at.x())), j = int(std::floor(at.y()));
                        if (!drawn.Contains(i, j)) continue;
                        ++met;
                        open += P.z() > gbuffer.z_m(i, j);
                    }
                }
                if (met > 0) A(x, y) = float(open) / float(met);
            }
        }
    });
    return A;
}

}  // namespace plumb
