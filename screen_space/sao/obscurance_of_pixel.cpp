#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "screen_space/depth_normal.h"
#include "screen_space/sao/obscurance_pass.h"

namespace plumb {
namespace {

DepthNormal Given(const Vec3f& normal) {
    const bool sound = normal.squaredNorm() <= kMostNormal2;
    return {.n = sound ? Vec3(normal.cast<double>()) : Vec3(0, 0, 0), .area = 0};
}

DepthNormal NormalOf(const GBuffer& gbuffer, NormalSource source, int x, int y) {
    switch (source) {
        case NormalSource::kDepth:
            return NormalFromDepth(gbuffer.view, gbuffer.z_m, x, y);
        case NormalSource::kFace:
            return Given(gbuffer.face_normal(x, y));
        case NormalSource::kShading:
            return Given(gbuffer.shading_normal(x, y));
    }
    return {};
}

/// A, with `angle(spiral_rad)` the angle of a tap that is at spiral_rad before it is turned.
template <class Angle>
double Obscurance(const GBuffer& gbuffer, const ZPyramid& pyramid,
                  const ObscuranceOptions& options, int x, int y, const Angle& angle) {
    const double z = gbuffer.z_m(x, y);
    if (!std::isfinite(z)) return 1;
    const TapOptions& taps = options.taps;
    const View& view = gbuffer.view;
    const double disc_px = DiscRadiusPx(view, options.sao.radius_m, z);
    if (taps.min_radius_px > 0 && disc_px <= taps.min_radius_px) return 1;
    const DepthNormal normal = NormalOf(gbuffer, options.normals, x, y);
    if (options.steepest_area > 0 && normal.area > options.steepest_area) return 1;

    const Vec3 C = view.Point(x + 0.5, y + 0.5, z);
    double sum = 0;
    for (int i = 0; i < taps.samples; ++i) {
        const UnitTap tap = TapOf(taps, i);
        const double h_px = std::max(tap.alpha * disc_px, taps.min_tap_px);
        const double theta = angle(tap.angle_rad);
        const Vec2 u(std::cos(theta), std::sin(theta));  // [McGuire12 eq. 7]
        const TapTexel texel = LookUpTap(taps, pyramid, x, y, h_px, u);
        const double z_i = pyramid(texel.level, texel.i, texel.j);
        if (!std::isfinite(z_i)) continue;
        const Vec3 Q = view.Point(texel.place_px.x(), texel.place_px.y(), z_i);
        sum += SaoFalloff(Q - C, normal.n, z, options.sao);
    }
    const double A = SaoFromMean(sum / taps.samples, options.sao);
    if (taps.min_radius_px == 0) return A;
    return 1 + (A - 1) * std::min(disc_px - taps.min_radius_px, 1.0);
}

}  // namespace

void Validate(const ObscuranceOptions& options) {
    Validate(options.sao);
    Validate(options.taps);
    if (!(options.steepest_area >= 0)) {
        throw Error(MustBe("ObscuranceOptions::steepest_area", options.steepest_area, ">= 0"));
    }
}

double ObscuranceOfPixel(const GBuffer& gbuffer, const ZPyramid& pyramid,
                         const ObscuranceOptions& options, int x, int y) {
    const int shift_px = options.taps.hash_shift_px;
    const std::int64_t hash = RotationHash(x + shift_px, y + shift_px, options.taps.hash);
    return Obscurance(gbuffer, pyramid, options, x, y, [&](double spiral_rad) {
        return TurnedAngle(spiral_rad, hash, options.taps.phi);
    });
}

double ObscuranceOfPixel(const GBuffer& gbuffer, const ZPyramid& pyramid,
                         const ObscuranceOptions& options, int x, int y, double phi_rad) {
    return Obscurance(gbuffer, pyramid, options, x, y,
                      [&](double spiral_rad) { return spiral_rad + phi_rad; });
}

}  // namespace plumb
