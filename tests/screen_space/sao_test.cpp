// The estimators of SAO against values worked out by hand, and their units.
#include "screen_space/sao/sao.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/error.h"

namespace plumb {
namespace {

constexpr SaoFalloffKind kAll[] = {SaoFalloffKind::kEquation1,   SaoFalloffKind::kHpg12,
                                   SaoFalloffKind::kSmooth,      SaoFalloffKind::kNoDivision,
                                   SaoFalloffKind::kLowContrast, SaoFalloffKind::kHighQuality};

/// f of a tap with the given v.v and v.n.
double FalloffOf(double vv, double vn, const SaoParams& params) {
    const Vec3 v(std::sqrt(vv - vn * vn), 0, vn);
    return SaoFalloff(v, {0, 0, 1}, -5, params);
}

// r = 1, beta = eps = 0.01 (high quality: eps = 0.001), v.n = 0.5. High quality has the factor
// 0.65 + 0.35 1.5 = 1.175 of a normal towards the eye. Six decimals are given.
TEST(SaoFalloff, HandComputedTaps) {
    struct Row {
        SaoFalloffKind kind;
        double at_quarter, at_half;
    };
    for (const Row& row :
         {Row{SaoFalloffKind::kHpg12, 1.130769, 0.576471},
          Row{SaoFalloffKind::kSmooth, 0.795072, 0.120098},
          Row{SaoFalloffKind::kNoDivision, 1.47, 0.98},
          Row{SaoFalloffKind::kLowContrast, 0.98, 0.98},
          Row{SaoFalloffKind::kHighQuality, 1.175 * 0.733534, 1.175 * 0.346136}}) {
        SaoParams params{.falloff = row.kind};
        if (row.kind == SaoFalloffKind::kHighQuality) params.epsilon_m2 = 0.001;
        EXPECT_NEAR(FalloffOf(0.25, 0.5, params), row.at_quarter, 6e-7);
        EXPECT_NEAR(FalloffOf(0.5, 0.5, params), row.at_half, 6e-7);
    }
    // Eq. 1 at z = -5, beta = 0.01: (0.5 - 0.05) / (0.25 + 0.01).
    const SaoParams eq1{
        .falloff = SaoFalloffKind::kEquation1, .bias_m = 0, .bias_per_depth = 0.01};
    EXPECT_NEAR(FalloffOf(0.25, 0.5, eq1), 0.45 / 0.26, 1e-15);
    EXPECT_NEAR(FalloffOf(4, 0.5, eq1), 0.45 / 4.01, 1e-15) << "no limit of reach";
}

// r = 2, v.v = 1, v.n = 0.5, beta = 0.1, eps = 0.25: over = 0.4.
TEST(SaoFalloff, TheRadiusEntersAsPrinted) {
    SaoParams params{.radius_m = 2, .bias_m = 0.1, .epsilon_m2 = 0.25};
    const auto f = [&](SaoFalloffKind kind) {
        params.falloff = kind;
        return FalloffOf(1, 0.5, params);
    };
    EXPECT_NEAR(f(SaoFalloffKind::kHpg12), 0.6 * 4 * 0.4 / 1.25, 1e-14);
    EXPECT_NEAR(f(SaoFalloffKind::kSmooth), 27 * 0.4 / 1.25, 1e-14);
    EXPECT_NEAR(f(SaoFalloffKind::kNoDivision), 4 * 0.75 * 0.4, 1e-14);
    EXPECT_NEAR(f(SaoFalloffKind::kLowContrast), 0.8, 1e-14);
    EXPECT_NEAR(f(SaoFalloffKind::kHighQuality), 1.175 * 0.75 * 0.4 / std::sqrt(1.25), 1e-14);
}

TEST(SaoFalloff, IsZeroInTheTangentPlaneAndBeyondTheRadius) {
    for (const SaoFalloffKind kind : kAll) {
        const SaoParams params{.falloff = kind};
        EXPECT_EQ(FalloffOf(0.25, 0, params), 0);
        EXPECT_EQ(FalloffOf(0.25, 0.01, params), 0) << "within the bias";
        EXPECT_EQ(FalloffOf(0.25, -0.3, params), 0);
        EXPECT_EQ(SaoFalloff({0, 0, 0}, {0, 0, 1}, -5, params), 0);
        EXPECT_GT(FalloffOf(0.25, 0.1, params), 0);
        if (kind == SaoFalloffKind::kEquation1) continue;
        EXPECT_EQ(FalloffOf(1.0001, 0.5, params), 0);
    }
}

// 1 - 5 sigma f / r^6 of two taps, one of which adds nothing.
TEST(SaoVisibility, HandComputedPixels) {
    const std::vector<Vec3> taps{{0, 0, 0.5}, {0.5, 0, 0}};
    const Vec3 n(0, 0, 1);
    SaoParams params{.falloff = SaoFalloffKind::kSmooth, .intensity = 0.2};
    EXPECT_NEAR(SaoVisibility(taps, n, -5, params), 1 - 0.2 * 5 * 0.795072 / 2, 6e-7);
    params.lift_dark = true;
    const double A = 1 - 0.397536;
    EXPECT_NEAR(SaoVisibility(taps, n, -5, params),
                (std::pow(A, 0.2) + 1.2 * A * A * A * A) / 2.2, 6e-7);
    params = {.falloff = SaoFalloffKind::kSmooth, .intensity = 10};
    EXPECT_EQ(SaoVisibility(taps, n, -5, params), 0);
    params = {.falloff = SaoFalloffKind::kLowContrast, .radius_m = 2, .intensity = 3};
    EXPECT_NEAR(SaoVisibility(taps, n, -5, params), 1 - 5 * 3 / 64.0 * 0.98 / 2, 1e-15);
    params = {.falloff = SaoFalloffKind::kEquation1,
              .bias_m = 0,
              .bias_per_depth = 0.01,
              .intensity = 0.2,
              .exponent = 2};
    EXPECT_NEAR(SaoVisibility(taps, n, -5, params),
                std::pow(1 - 2 * 0.2 * (0.45 / 0.26) / 2, 2), 1e-15);
    params = {.falloff = SaoFalloffKind::kHighQuality, .intensity = 2, .epsilon_m2 = 0.001};
    const std::vector<Vec3> four{taps[0], taps[1], taps[1], taps[1]};
    EXPECT_NEAR(SaoVisibility(four, n, -5, params),
                std::pow(1 - std::sqrt(3 * 1.175 * 0.733534 / 4), 2), 1e-6);
}

// The same scene told in other units has the same A. Tolerance: the rounding of some 20 operations.
TEST(SaoVisibility, IsTheSameInEveryUnit) {
    const std::vector<Vec3> taps{{0.1, 0.2, 0.3}, {-0.4, 0.1, 0.2}, {0, 0.3, 0.05}};
    const Vec3 n = Vec3(0.2, -0.1, 1).normalized();
    for (const SaoFalloffKind kind : kAll) {
        const SaoParams params{
            .falloff = kind, .radius_m = 0.8, .bias_per_depth = 0.001, .intensity = 0.1};
        const double A = SaoVisibility(taps, n, -3, params);
        EXPECT_GT(A, 0.05);
        EXPECT_LT(A, 0.95);
        for (const double scale : {10.0, 100.0, 0.01}) {
            std::vector<Vec3> scaled = taps;
            for (Vec3& v : scaled) v *= scale;
            const SaoParams other = InOtherUnit(params, scale);
            EXPECT_NEAR(SaoVisibility(scaled, n, -3 * scale, other), A, 1e-14);
            EXPECT_EQ(other.epsilon_m2, params.epsilon_m2 * scale * scale);
        }
    }
}

TEST(SaoVisibility, SigmaHasAUnit) {
    EXPECT_EQ(InOtherUnit({.falloff = SaoFalloffKind::kSmooth, .intensity = 2}, 100).intensity,
              200);
    EXPECT_EQ(IntensityPower(SaoFalloffKind::kEquation1), 1);
    EXPECT_EQ(IntensityPower(SaoFalloffKind::kNoDivision), 5);
    EXPECT_EQ(IntensityPower(SaoFalloffKind::kHighQuality), 0);
}

TEST(SaoParams, BadValuesAreNamed) {
    const auto message = [](const SaoParams& params) {
        try {
            Validate(params);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(message({.radius_m = -1}), "SaoParams::radius_m = -1, must be in [1e-4, 1e7]");
    EXPECT_EQ(message({.radius_m = 0}), "SaoParams::radius_m = 0, must be in [1e-4, 1e7]");
    EXPECT_EQ(message({.epsilon_m2 = 0}),
              "SaoParams::epsilon_m2 = 0, must be in [1e-12, 1e12]");
    EXPECT_EQ(message({.intensity = std::nan("")}),
              "SaoParams::intensity = nan, must be in [0, 1e30]");
    EXPECT_EQ(message({.radius_m = 1e6}), "");
}

}  // namespace
}  // namespace plumb
