#include "screen_space/sao/tap_lookup.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace plumb {
namespace {

void CheckRange(const char* field, double value, double low, double high, const char* rule) {
    if (!(value >= low && value <= high)) {
        throw Error(MustBe(std::string("TapOptions::") + field, value, rule));
    }
}

}  // namespace

void Validate(const TapOptions& taps) {
    CheckRange("samples", taps.samples, 1, 4096, "in [1, 4096]");
    CheckRange("hash_shift_px", taps.hash_shift_px, -16383, 16383, "in [-16383, 16383]");
    CheckRange("turns", taps.turns, 0, 65536, "in [0, 65536]");
    CheckRange("full_turn_rad", taps.full_turn_rad, 6, 7, "in [6, 7]");
    CheckRange("log2_switch_px", taps.log2_switch_px, 0, 14, "in [0, 14]");
    CheckRange("coarsest_level", taps.coarsest_level, 0, 14, "in [0, 14]");
    CheckRange("min_radius_px", taps.min_radius_px, 0, 1e3, "in [0, 1000]");
    CheckRange("min_tap_px", taps.min_tap_px, 0, 1e3, "in [0, 1000]");
}

UnitTap TapOf(const TapOptions& taps, int i) {
    if (taps.pattern == TapPattern::kSunflower) return SunflowerTap(i, taps.samples);
    return SpiralTap(i, taps.samples, taps.turns > 0 ? taps.turns : SpiralTurns(taps.samples),
                     taps.full_turn_rad);
}

double DiscRadiusPx(const View& view, double radius_m, double z_m) {
    return std::min(-radius_m * view.PixelsPerMetre() / z_m, kWidestPx);  // [McGuire12 eq. 5]
}

int LevelOfTap(double h_px, int log2_switch_px, int coarsest) {
    if (!(h_px >= 1)) return 0;
    return std::clamp(std::ilogb(h_px) - log2_switch_px, 0, coarsest);  // [McGuire12 eq. 9]
}

TapTexel LookUpTap(const TapOptions& taps, const ZPyramid& pyramid, int x, int y, double h_px,
                   const Vec2& u) {
    const bool sum = taps.rounding == TapRounding::kSum;
    const auto texel = [&](int pixel, double offset_px) {
        return sum ? std::trunc(pixel + offset_px) : pixel + std::trunc(offset_px);
    };
    const Vec2 met(texel(x, h_px * u.x()), texel(y, h_px * u.y()));
    const int i = int(std::clamp(met.x(), 0.0, double(pyramid.At(0).width - 1)));
    const int j = int(std::clamp(met.y(), 0.0, double(pyramid.At(0).height - 1)));

    TapTexel found;
    found.level = LevelOfTap(h_px, taps.log2_switch_px, pyramid.Coarsest());
    found.i = i >> found.level;  // [McGuire12 eq. 10]
    found.j = j >> found.level;
    const bool inside = met == Vec2(i, j);
    if (!inside && taps.outside == TapOutside::kBorderPoint) {
        found.place_px = Vec2(i + 0.5, j + 0.5);
    } else if (taps.place == TapPlace::kTexel || !inside) {
        found.place_px = met + Vec2(0.5, 0.5);
    } else if (taps.place == TapPlace::kTap) {
        found.place_px = Vec2(x + 0.5, y + 0.5) + h_px * u;
    } else {
        found.place_px = double(1 << found.level) * Vec2(found.i + 0.5, found.j + 0.5);
    }
    return found;
}

}  // namespace plumb
