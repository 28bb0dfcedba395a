// All triangles of a mesh, one after the other: what a caster's tree must not change.
#pragma once

#include "rays/packets/pluecker_test.h"
#include "rays/packets/walk_ray.h"
#include "rays/triangle.h"

namespace plumb {

inline Corners CornersIn(const Mesh& mesh, std::uint32_t id) {
    Corners corners;
    const Triangle triangle = TriangleOf(mesh, id);
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t k = 0; k < 3; ++k) {
            corners[c][k] = float(triangle.corners_m[c][int(k)]);
        }
    }
    return corners;
}

/// The least (t, triangle) of those with an area that `Test` meets in [near, far].
template <class Test>
Hit NearestOfAll(const Mesh& mesh, const Ray& given) {
    BspBox everywhere;
    everywhere.high_m = {1, 1, 1};
    const WalkRay ray = ReadyToWalk(given, everywhere);
    const Test test(ray.origin_m, ray.direction);
    Hit nearest;
    float best = ray.far;
    for (std::uint32_t id = 0; id < 2 * mesh.quads.size(); ++id) {
        if (id % 2 == 1 && mesh.quads[id / 2][2] == mesh.quads[id / 2][3]) continue;
        if (!(TriangleOf(mesh, id).Cross().squaredNorm() > 0)) continue;
        Meeting at;
        if (!test.Meets(RecordOfCorners(CornersIn(mesh, id)), at)) continue;
        if (!(at.t >= ray.near && (at.t < best || (at.t == best && id < nearest.triangle)))) {
            continue;
        }
        best = at.t;
        nearest = {id, at.b_1, at.b_2, at.t * ray.per_length};
    }
    return nearest;
}

}  // namespace plumb
