#include "heightfield/relief/lane_rays.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace plumb {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// A place along an axis of an endless field, folded back into it.
void FoldInto(int cells, Boundary boundary, double& at, double& step) {
    if (boundary == Boundary::kWrap) {
        at -= cells * std::floor(at / cells);
    } else {
        at -= 2 * cells * std::floor(at / (2 * cells));
        if (at > cells) at = 2 * cells - at, step = -step;
    }
}

/// From where to where a line is between 0 and `cells`.
void ClipTo(int cells, double at, double step, double& t_in, double& t_out) {
    if (step == 0) {
        if (at < 0 || at > cells) t_out = -1;
        return;
    }
    const double t_0 = -at / step, t_1 = (cells - at) / step;
    t_in = std::max(t_in, std::min(t_0, t_1));
    t_out = std::min(t_out, std::max(t_0, t_1));
}

/// Height of the surface at (fu, fv) of cell (i, j).
template <class T>
double SurfaceM(const HeightPyramid<T>& field, ReliefSurface surface, int i, int j, double fu,
                double fv) {
    const double z_00 = field.Corner(i, j), z_10 = field.Corner(i + 1, j);
    const double z_01 = field.Corner(i, j + 1), z_11 = field.Corner(i + 1, j + 1);
    if (surface == ReliefSurface::kBilinear) {
        return (1 - fv) * ((1 - fu) * z_00 + fu * z_10) + fv * ((1 - fu) * z_01 + fu * z_11);
    }
    return fu >= fv ? z_00 + fu * (z_10 - z_00) + fv * (z_11 - z_10)
                    : z_00 + fv * (z_01 - z_00) + fu * (z_11 - z_01);
}

// Clips and folds a ray that starts anywhere; decides it where it never walks.
template <class T>
void Enter(const HeightPyramid<T>& field, ReliefSurface surface, RayStart<T>& s) {
    const double top = field.HighestM();
    double t_in = 0, t_out = kInf;
    const auto leaves = [&] { s.decided = true, s.hit = {kSky, 0}; };
    if (s.z > top) {
        if (s.dz >= 0) return leaves();
        t_in = (top - s.z) / s.dz;
    }
    if (field.GetBoundary() == Boundary::kOpen) {
        ClipTo(field.CellsX(), s.u, s.du, t_in, t_out);
        ClipTo(field.CellsY(), s.v, s.dv, t_in, t_out);
        if (!(t_in <= t_out)) return leaves();
    }
    s.u += t_in * s.du, s.v += t_in * s.dv;
    s.z = s.z > top ? std::min(top, s.z + t_in * s.dz) : s.z + t_in * s.dz;
    if (s.z > top) return leaves();
    if (field.GetBoundary() != Boundary::kOpen) {
        FoldInto(field.CellsX(), field.GetBoundary(), s.u, s.du);
        FoldInto(field.CellsY(), field.GetBoundary(), s.v, s.dv);
    }
    s.t_before = t_in;
    s.i = std::clamp(int(std::floor(s.u)), 0, field.CellsX() - 1);
    s.j = std::clamp(int(std::floor(s.v)), 0, field.CellsY() - 1);
    const double fu = std::clamp(s.u - s.i, 0.0, 1.0), fv = std::clamp(s.v - s.j, 0.0, 1.0);
    if (s.z <= SurfaceM(field, surface, s.i, s.j, fu, fv)) {
        const bool upper = surface == ReliefSurface::kTriangles ? fu < fv : field.Falling();
        s.decided = true, s.hit = {field.FacetNumber(s.i, s.j, upper ? 1 : 0), t_in};
    }
}

// How far along a ray to look, and what it is then.
template <class T>
void EndOf(const HeightPyramid<T>& field, RayStart<T>& s) {
    const double level_m = std::hypot(s.du * field.SpacingXM(), s.dv * field.SpacingYM());
    const double far =
        field.GetBoundary() == Boundary::kOpen || level_m == 0 ? kInf : field.FarM() / level_m;
    const double over =
        s.dz > 0 ? std::max(0.0, (double(field.HighestM()) - s.z) / s.dz) : kInf;
    s.t_end = std::min(far, over);
    s.ends_lost = far < over;
}

}  // namespace

template <class T>
RayStart<T> StartOf(const HeightPyramid<T>& field, ReliefSurface surface, const FieldRay& ray) {
    RayStart<T> s;
    s.u = ray.origin_m.x() / field.SpacingXM(), s.v = ray.origin_m.y() / field.SpacingYM();
    s.du = ray.direction.x() / field.SpacingXM(), s.dv = ray.direction.y() / field.SpacingYM();
    s.z = ray.origin_m.z(), s.dz = ray.direction.z();
    if (field.Falling()) s.v = field.CellsY() - s.v, s.dv = -s.dv;
    if (ray.facet == FieldRay::kNoFacet) {
        Enter(field, surface, s);
    } else {
        const std::int64_t cell = ray.facet / 2;
        s.i = int(cell % field.CellsX()), s.j = int(cell / field.CellsX());
        s.half = int(ray.facet % 2);
        if (field.Falling()) s.j = field.CellsY() - 1 - s.j, s.half = 1 - s.half;
    }
    EndOf(field, s);
    return s;
}

template <class T>
PointStart<T>::PointStart(const HeightPyramid<T>& field, ReliefSurface surface,
                          const FieldRay& point)
    : at_(StartOf(field, surface, point)),
      per_x_(T(1 / field.SpacingXM())),
      per_y_(T((field.Falling() ? -1 : 1) / field.SpacingYM())),
      headroom_m_(T(double(field.HighestM()) - point.origin_m.z())),
      far_m_(T(field.FarM())),
      open_(field.GetBoundary() == Boundary::kOpen) {}

template <class T>
void PointStart<T>::AddAll(std::span<const Vec3f> directions, LaneRays<T>& block) const {
    const std::size_t n = directions.size();
    block.count = n;
    std::fill_n(block.u.begin(), n, T(at_.u));
    std::fill_n(block.v.begin(), n, T(at_.v));
    std::fill_n(block.z.begin(), n, T(at_.z));
    std::fill_n(block.i.begin(), n, at_.i);
    std::fill_n(block.j.begin(), n, at_.j);
    std::fill_n(block.half.begin(), n, at_.half);
    const T inf = std::numeric_limits<T>::infinity();
    for (std::size_t k = 0; k < n; ++k) {
        const T x = directions[k].x(), y = directions[k].y(), z = directions[k].z();
        block.du[k] = x * per_x_, block.dv[k] = y * per_y_, block.dz[k] = z;
        const T level = std::sqrt(x * x + y * y);
        const T far = open_ ? inf : far_m_ / level;  // Upright: inf.
        const T over = z > 0 ? std::max(T(0), headroom_m_ / z) : inf;
        block.t_end[k] = std::min(far, over);
        block.ends_lost[k] = far < over;
    }
}

template RayStart<float> StartOf(const HeightPyramid<float>&, ReliefSurface, const FieldRay&);
template RayStart<double> StartOf(const HeightPyramid<double>&, ReliefSurface, const FieldRay&);
template class PointStart<float>;
template class PointStart<double>;

}  // namespace plumb
