// Many rays against a height field by its maximum mip-map, exactly: no step length, no cone.
//
// A ray walks from square to square. One whose highest corner lies below the ray is left behind in
// one step, however large; else its quarters are tried, down to the cell, and there the ray is
// held against the surface itself:
//
//       triangles        z_ray - z_surface is straight between entry, diagonal and exit
//       bilinear patch   z_ray - z_surface is a parabola, A s^2 + B s + C, met at its first root
//
// Rays are independent, so as many as the machine has lanes walk at once, and a lane that is done
// takes the next ray.
//
// Source   [Tevs08]; the patch's parabola is textbook algebra. Walking by topology instead of by
//          rounded places is that of heightfield/facet_walk.h, which this is tested against.
// Symbols  x, y metres from texel (0, 0); t in lengths of the ray's direction.
// Beware   Ground is solid: a ray that starts at or below the surface is met where it starts,
//          and so is one that enters an open field through its side, below its border's height.
//          Over an endless field (wrap, mirror) a ray that does not rise always meets something;
//          beyond FarDistanceM it is given up and called lost, never sky.
//          No operation is fused and lanes do not speak to each other: the answers are the same
//          on every machine. float answers are double's but where a ray passes an edge or skims
//          a facet within a few roundings of its place and height.
#pragma once

#include <cstdint>
#include <span>

#include "core/vec.h"
#include "heightfield/ray_cast.h"
#include "heightfield/relief/height_pyramid.h"

namespace plumb {

/// Between the heights: the facets of heightfield/facet.h, or what a texture's bilinear filter
/// makes of the same four corners.
enum class ReliefSurface { kTriangles, kBilinear };

/// A ray, and the facet that it starts on. `direction` must not vanish; it need not be of unit
/// length.
struct FieldRay {
    static constexpr std::int64_t kNoFacet = -1;

    std::int64_t facet = kNoFacet;  ///< kNoFacet: it starts anywhere. Else it heads above it.
    Vec3 origin_m = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ();
};

/// The nearest thing that a ray meets.
struct FieldHit {
    std::int64_t facet = kSky;  ///< Or kSky, kLost. Of a bilinear patch: its cell's facet 2c.
    double t = 0;               ///< Where a facet is met.
};

/// hits[i] is what rays[i] meets.
template <class T>
void CastRays(const HeightPyramid<T>& field, ReliefSurface surface,
              std::span<const FieldRay> rays, std::span<FieldHit> hits);

/// Bit i % 64 of met[i / 64] tells whether directions[i] from one point of one facet meets
/// anything (kLost counts as met: it does not rise). Bits beyond are 0.
template <class T>
void MeetFromPoint(const HeightPyramid<T>& field, ReliefSurface surface, const FieldRay& point,
                   std::span<const Vec3f> directions, std::span<std::uint64_t> met);

extern template void CastRays(const HeightPyramid<float>&, ReliefSurface,
                              std::span<const FieldRay>, std::span<FieldHit>);
extern template void CastRays(const HeightPyramid<double>&, ReliefSurface,
                              std::span<const FieldRay>, std::span<FieldHit>);
extern template void MeetFromPoint(const HeightPyramid<float>&, ReliefSurface, const FieldRay&,
                                   std::span<const Vec3f>, std::span<std::uint64_t>);
extern template void MeetFromPoint(const HeightPyramid<double>&, ReliefSurface, const FieldRay&,
                                   std::span<const Vec3f>, std::span<std::uint64_t>);

}  // namespace plumb
