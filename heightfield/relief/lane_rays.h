// Rays as the lanes of pyramid_cast.cpp take them: in cells of the stored field, numbers of one
// kind side by side, and what became of them.
//
// Beware   Inside the room only: callers see pyramid_cast.h.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "heightfield/relief/pyramid_cast.h"

namespace plumb {

/// Rays that are readied at once.
inline constexpr std::size_t kLaneRays = 512;

/// Where a ray starts in the stored field: folded into it, clipped to its box.
template <class T>
struct RayStart {
    double u = 0, v = 0, z = 0, du = 0, dv = 0, dz = 0;  ///< Cells and metres; a unit of t.
    int i = 0, j = 0;
    int half = -1;     ///< Of the cell, that the ray starts on; -1 = on none.
    double t_end = 0;  ///< Where it is above everything, or too far.
    bool ends_lost = false;
    double t_before = 0;   ///< What of the ray was clipped.
    bool decided = false;  ///< Without a walk: `hit`.
    FieldHit hit = {};
};

template <class T>
RayStart<T> StartOf(const HeightPyramid<T>& field, ReliefSurface surface, const FieldRay& ray);

template <class T>
struct LaneRays {
    using TI = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;

    void Add(const RayStart<T>& start) {
        u[count] = T(start.u), v[count] = T(start.v), z[count] = T(start.z);
        du[count] = T(start.du), dv[count] = T(start.dv), dz[count] = T(start.dz);
        t_end[count] = T(start.t_end), ends_lost[count] = start.ends_lost;
        i[count] = start.i, j[count] = start.j, half[count] = start.half;
        ++count;
    }

    std::size_t count = 0;
    alignas(64) std::array<T, kLaneRays> u, v, z, du, dv, dz, t_end;
    alignas(64) std::array<TI, kLaneRays> i, j, half;
    std::array<std::uint8_t, kLaneRays> ends_lost;
};

template <class T>
struct LaneHits {
    std::array<std::uint8_t, kLaneRays> met;
    std::array<T, kLaneRays> t;
    std::array<std::int32_t, kLaneRays> i, j;
    std::array<std::uint8_t, kLaneRays> upper;
};

/// One point of a facet from which many rays start.
template <class T>
class PointStart {
  public:
    PointStart(const HeightPyramid<T>& field, ReliefSurface surface, const FieldRay& point);

    /// Appends directions.size() <= kLaneRays rays to an empty block.
    void AddAll(std::span<const Vec3f> directions, LaneRays<T>& block) const;

  private:
    RayStart<T> at_;
    T per_x_, per_y_, headroom_m_, far_m_;
    bool open_;
};

extern template RayStart<float> StartOf(const HeightPyramid<float>&, ReliefSurface,
                                        const FieldRay&);
extern template RayStart<double> StartOf(const HeightPyramid<double>&, ReliefSurface,
                                         const FieldRay&);
extern template class PointStart<float>;
extern template class PointStart<double>;

}  // namespace plumb
