#include "screen_space/sao/obscurance_pass.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "screen_space/sao/obscurance_tile.h"

namespace plumb {
namespace {

/// What the sum of the taps' terms is multiplied with: see the terms in obscurance_tile.cpp.
double PerTap(const SaoParams& sao, int samples) {
    const double r = sao.radius_m, five = 5 * sao.intensity / samples;
    switch (sao.falloff) {
        case SaoFalloffKind::kEquation1:
            return 2 * sao.intensity / samples;  // [McGuire12 eq. 1]
        case SaoFalloffKind::kHpg12:
            return 0.6 * five / std::pow(r, 4);
        case SaoFalloffKind::kSmooth:
            return five;
        case SaoFalloffKind::kNoDivision:
            return 4 * five / std::pow(r, 6);
        case SaoFalloffKind::kLowContrast:
            return 2 * five / std::pow(r, 6);
        case SaoFalloffKind::kHighQuality:
            return 3.0 / samples;
    }
    return 0;
}

}  // namespace

ObscuranceTask::ObscuranceTask(const GBuffer& gbuffer, const ZPyramid& z_pyramid,
                               const ObscuranceOptions& of)
    : pyramid(&z_pyramid),
      width(gbuffer.view.DrawnWidth()),
      height(gbuffer.view.DrawnHeight()),
      options(of) {
    if (of.normals == NormalSource::kFace) normals = &gbuffer.face_normal;
    if (of.normals == NormalSource::kShading) normals = &gbuffer.shading_normal;
    const View& view = gbuffer.view;
    // View::Point, solved for x / z and y / z.
    a_x = float(-2 * view.tan_half_width / view.width_px);
    b_x = float(view.tan_half_width * (1 + 2.0 * view.guard_px / view.width_px));
    a_y = float(2 * view.tan_half_height / view.height_px);
    b_y = float(-view.tan_half_height * (1 + 2.0 * view.guard_px / view.height_px));
    const SaoParams& sao = of.sao;
    disc = float(sao.radius_m * view.PixelsPerMetre());  // [McGuire12 eq. 5]
    steepest_area = normals == nullptr ? float(of.steepest_area) : 0;
    for (int i = 0; i < of.taps.samples; ++i) {
        const UnitTap tap = TapOf(of.taps, i);
        taps.push_back({.alpha = float(tap.alpha),
                        .cosine = float(std::cos(tap.angle_rad)),
                        .sine = float(std::sin(tap.angle_rad)),
                        .spiral_rad = float(tap.angle_rad)});
    }
    const double farthest_vv = 1e30;  // of eq. 1, which knows no radius; its square is no float
    const double r2 = sao.radius_m * sao.radius_m;
    bias = float(sao.bias_m);
    bias_per_depth = float(sao.bias_per_depth);
    epsilon = float(sao.epsilon_m2);
    per_r2 = float(1 / r2);
    most_vv = float(sao.falloff == SaoFalloffKind::kEquation1 ? farthest_vv : r2);
    per_tap = float(std::min(PerTap(sao, of.taps.samples), 1e30));
}

Image<float> SampleObscurance(const GBuffer& gbuffer, const ZPyramid& pyramid,
                              const ObscuranceOptions& options, const PixelRect& where) {
    Image<float> A(gbuffer.z_m.Width(), gbuffer.z_m.Height(), 1.0f);
    const ObscuranceTask task(gbuffer, pyramid, options);
    ForEachTile(where, [&](const PixelRect& tile) { ObscureTile(task, tile, A); });
    return A;
}

}  // namespace plumb
