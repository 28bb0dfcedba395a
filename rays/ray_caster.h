// What a ray meets: all that truth/ asks of a ray caster.
//
// Behind it stand Embree (embree_caster.h) and a packet tracer of our own; they share nothing
// but this interface, so each checks the other. Rays come in spans, because a loop inside is
// faster than a call a ray, and because the fastest form (many rays from one point) needs them
// together.
//
// Symbols  a ray is { origin + t direction, near <= t <= far }; b_1, b_2 barycentric
//          coordinates of the triangle's second and third corner, see rays/triangle.h.
// Beware   Directions need not be unit vectors: t counts in their lengths. Whether something
//          exactly at near or far is met is left open. Numbers are float: start rays off
//          surfaces as rays/leave_surface.h does.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "core/vec.h"

namespace plumb {

struct Ray {
    Vec3f origin_m = Vec3f::Zero();
    float near = 0;
    Vec3f direction = Vec3f::UnitZ();
    float far = std::numeric_limits<float>::infinity();
};

/// The nearest thing that a ray meets.
struct Hit {
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    std::uint32_t triangle = kNone;  ///< 2 face + half, as in rays/triangle.h.
    float b_1 = 0, b_2 = 0;
    float t = std::numeric_limits<float>::infinity();  ///< In lengths of the direction.

    bool Met() const { return triangle != kNone; }
};

/// What a caster was given and what it left out.
struct GeometryCounts {
    std::int64_t faces = 0;      ///< Of the mesh.
    std::int64_t triangles = 0;  ///< That rays can meet.
    std::int64_t zero_area = 0;  ///< Triangles without area, kept out.
};

/// Queries may come from any number of threads at once.
class RayCaster {
  public:
    virtual ~RayCaster() = default;

    /// hits[i] is the nearest thing that rays[i] meets.
    virtual void Closest(std::span<const Ray> rays, std::span<Hit> hits) const = 0;

    /// Bit i % 64 of met[i / 64] tells whether rays[i] meets anything; bits beyond are 0.
    virtual void Any(std::span<const Ray> rays, std::span<std::uint64_t> met) const = 0;

    /// The same for rays that start at one point with one near and one far.
    virtual void AnyFromPoint(const Ray& common, std::span<const Vec3f> directions,
                              std::span<std::uint64_t> met) const = 0;

    virtual GeometryCounts Counts() const = 0;
};

/// Words of 64 bits that `rays` need.
constexpr std::size_t BitWords(std::size_t rays) {
    return (rays + 63) / 64;
}

}  // namespace plumb
