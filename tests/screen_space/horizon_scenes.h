// Scenes of which HBAO, GTAO and the bitmask have known values, each with how much of them is known.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "screen_space/horizon/gtao.h"
#include "screen_space/horizon/hbao.h"
#include "screen_space/horizon/visibility_bitmask.h"
#include "tests/screen_space/made_gbuffers.h"

namespace plumb {

/// Slices and steps enough to meet every pixel that a slice crosses.
inline SliceSampling EveryPixelOfASlice(double radius_m, int slices = 64) {
    return {.radius_m = radius_m,
            .slices = slices,
            .steps = 4096,
            .step_power = 1,
            .jitter = false};
}

inline HbaoOptions UnattenuatedHbao(const SliceSampling& sampling) {
    return {.sampling = sampling, .attenuate = false};
}

inline GtaoOptions HardGtao(const SliceSampling& sampling) {
    return {.sampling = sampling, .falloff_start = 1};
}

/// All that is behind a sample is hidden, as for HBAO and GTAO.
inline BitmaskOptions ThickBitmask(const SliceSampling& sampling, SectorMeasure measure,
                                   SectorRounding rounding = SectorRounding::kRound) {
    return {.sampling = sampling,
            .thickness_m = std::numeric_limits<double>::infinity(),
            .sectors = 64,
            .measure = measure,
            .rounding = rounding};
}

/// Looking straight down into a round pit, 1 m deep: rim at z = -4, floor at z = -5. From the
/// middle of the floor the sky is a cone of half-angle atan(radius).
struct Pit {
    static constexpr int kSide = 513, kMiddle = kSide / 2;
    double radius_m;
    GBuffer gbuffer;

    explicit Pit(double radius) : radius_m(radius) {
        const auto outside = [radius](const Vec3& P) { return P.head<2>().norm() >= radius; };
        gbuffer =
            MadeGBuffer(MadeView(kSide, kSide, 2 * radius / 4),
                        Union(MadePlane({0, 0, 1}, -4, outside), MadePlane({0, 0, 1}, -5)));
    }

    /// The rim's first pixel centre lies on a slice at most this much outside the rim: 1.5
    /// pixels.
    double SlackM() const { return 1.5 * 4 * radius_m / kSide; }

    /// Reaches beyond the rim.
    SliceSampling Sampling() const { return EveryPixelOfASlice(2 + 2 * radius_m); }
};

/// The largest step of the number f from the pit's own half-angle to that of the rim as drawn.
template <class OfHalfAngle>
void ExpectOfPit(const Pit& pit, double value, double slack, const OfHalfAngle& of) {
    const double least = of(std::atan(pit.radius_m));
    const double greatest = of(std::atan(pit.radius_m + pit.SlackM()));
    EXPECT_GE(value, least - slack);
    EXPECT_LE(value, greatest + slack);
    EXPECT_LT(greatest - least, 0.01);  // The bound says something.
}

}  // namespace plumb
