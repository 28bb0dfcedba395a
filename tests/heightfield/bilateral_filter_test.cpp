#include "heightfield/bilateral_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.h"
#include "heightfield/procedural/terrain.h"
#include "tests/closed_forms/analytic_fields.h"

namespace plumb {
namespace {

HeightField Rough(int width, int height, Boundary boundary) {
    const HeightField wrapped =
        MakeTerrain({.seed = 5, .roughness = 0.8},
                    {.width_texels = width, .height_texels = height, .amplitude_m = 1});
    return HeightField(wrapped.HeightsM(), 0.25, 0.5, boundary);
}

TEST(BilateralFilter, LeavesAConstantUnchanged) {
    for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror, Boundary::kOpen}) {
        const HeightField flat = MakeFlat({.width_texels = 4,
                                           .height_texels = 5,
                                           .spacing_m = 1,
                                           .height_m = 0.1,
                                           .boundary = boundary});
        const HeightField out = Filtered(flat, {.radius_texels = 7, .tolerance_m = 1e-3});
        EXPECT_EQ(out.HeightsM(), flat.HeightsM());
        EXPECT_EQ(out.GetBoundary(), boundary);
    }
}

// Expected: beyond the tolerance w_r is 0, so no height on one side of the step enters the
// other: exact, not near.
TEST(BilateralFilter, KeepsAStepOfTheToleranceExactly) {
    const HeightField trench =
        MakeTrench({.width_m = 8, .depth_m = 0.5, .width_texels = 8, .land_texels = 8});
    for (const double tolerance_m : {0.1, 0.5}) {
        const HeightField kept =
            Filtered(trench, {.radius_texels = 3, .tolerance_m = tolerance_m});
        EXPECT_EQ(kept.HeightsM(), trench.HeightsM()) << tolerance_m;
    }
    const HeightField softened = Filtered(trench, {.radius_texels = 3, .tolerance_m = 0.6});
    EXPECT_NE(softened.HeightsM(), trench.HeightsM());
}

// Expected: by hand. One raised texel, d = 0.1, t = 0.2, r = 1: w_r = (1 - 1/4)^2 = 9/16; the
// neighbours' w_s are e^(-1/2) (four) and e^-1 (four). The raised texel falls to
// 0.1 - 0.1 (4 e^(-1/2) + 4 e^-1) 9/16 / (1 + (4 e^(-1/2) + 4 e^-1) 9/16), and an edge
// neighbour rises to 0.1 e^(-1/2) 9/16 / (1 + 3 e^(-1/2) + 4 e^-1 + e^(-1/2) 9/16).
TEST(BilateralFilter, OneRaisedTexelByHand) {
    Image<double> heights_m(5, 5, 0.0);
    heights_m(2, 2) = 0.1;
    const HeightField out = Filtered(HeightField(heights_m, 1, 1), {.tolerance_m = 0.2});
    const double e1 = std::exp(-0.5), e2 = std::exp(-1.0), w_r = 9.0 / 16;
    const double others = (4 * e1 + 4 * e2) * w_r;
    EXPECT_NEAR(out.At(2, 2), 0.1 - 0.1 * others / (1 + others), 1e-16);
    EXPECT_NEAR(out.At(1, 2), 0.1 * e1 * w_r / (1 + 3 * e1 + 4 * e2 + e1 * w_r), 1e-16);
    EXPECT_NEAR(out.At(3, 3), 0.1 * e2 * w_r / (1 + 4 * e1 + 3 * e2 + e2 * w_r), 1e-16);
    EXPECT_EQ(out.At(0, 2), 0);
}

// A ramp whose steps of an 8-bit map are q = 1/255 high and 6 texels long, on 255 steps.
//
// Expected: where |d| << t the filter is the Gaussian of the window; its effect on the stairs
// is worked out beside it, along x only (the rows are equal), with w_r = 1. Within a window of
// radius r heights differ by at most ceil(r / 6) q, so w_r >= (1 - (q / t)^2)^2 for r <= 6, and
// the result moves by at most q ((q / t)^2 2).
// The stairs are off the ramp by (5/2 - k) q / 6 in the k-th texel of a step, 0.285 q RMS. With
// r = 1 a neighbour weighs w = e^(-1/2) / (1 + 2 e^(-1/2)) and only the first and the last
// texel of a step move, by w q: 0.173 q RMS. With r = 4 at most an eighth is left (0.033 q).
TEST(BilateralFilter, SmoothsTheStairsOfAQuantizedRamp) {
    const double q = 1.0 / 255, t = 0.2;
    const int run = 6, n = 255 * run;
    Image<double> stairs(n, 3);
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < n; ++i) stairs(i, j) = q * (i / run);
    const HeightField field(stairs, 1, 1, Boundary::kOpen);
    auto ramp = [&](int i) { return q * (i + 0.5 - run / 2.0) / run; };

    const double w = std::exp(-0.5) / (1 + 2 * std::exp(-0.5));
    const double rms_of_stairs = std::sqrt((25 + 9 + 1) / (3 * 144.0));
    const double rms_at_1 =
        std::sqrt((std::pow(5.0 / 12 - w, 2) + std::pow(3.0 / 12, 2) + 1.0 / 144) / 3);

    struct Case {
        int radius;
        double least_rms, most_rms;  // In q; margins: the movement by w_r, 1e-3.
    };
    for (const Case c :
         {Case{1, rms_at_1 - 1e-3, rms_at_1 + 1e-3}, Case{4, 0, rms_of_stairs / 8}}) {
        const HeightField out = Filtered(field, {.radius_texels = c.radius, .tolerance_m = t});
        double before2 = 0, after2 = 0;
        int count = 0;
        for (int i = c.radius; i < n - c.radius; ++i) {
            double sum = 0, norm = 0;
            for (int d = -c.radius; d <= c.radius; ++d) {
                const double w_s = std::exp(-0.5 * d * d / (c.radius * c.radius));
                sum += w_s * stairs(i + d, 1);
                norm += w_s;
            }
            EXPECT_NEAR(out.At(i, 1), sum / norm, 2 * q * (q / t) * (q / t)) << i;
            before2 += std::pow(stairs(i, 1) - ramp(i), 2);
            after2 += std::pow(out.At(i, 1) - ramp(i), 2);
            ++count;
        }
        // Whole steps but for two texels at either end: 1e-3 covers what they leave out.
        EXPECT_NEAR(std::sqrt(before2 / count) / q, rms_of_stairs, 1e-3);
        const double rms = std::sqrt(after2 / count) / q;
        EXPECT_GE(rms, c.least_rms) << c.radius;
        EXPECT_LE(rms, c.most_rms) << c.radius;
    }
}

TEST(BilateralFilter, CommutesWithTheSymmetriesOfTheGrid) {
    const BilateralFilter filter{.radius_texels = 2, .tolerance_m = 0.3};
    for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror, Boundary::kOpen}) {
        const HeightField field = Rough(17, 12, boundary);
        const HeightField a = Filtered(MirroredX(field), filter);
        const HeightField b = MirroredX(Filtered(field, filter));
        const HeightField c = Filtered(QuarterTurned(field), filter);
        const HeightField d = QuarterTurned(Filtered(field, filter));
        // The sums run in another order: 25 terms, heights below 1.
        for (std::size_t k = 0; k < a.HeightsM().Pixels().size(); ++k) {
            EXPECT_NEAR(a.HeightsM().Pixels()[k], b.HeightsM().Pixels()[k], 1e-14);
            EXPECT_NEAR(c.HeightsM().Pixels()[k], d.HeightsM().Pixels()[k], 1e-14);
        }
        EXPECT_EQ(a.GetDiagonal(), b.GetDiagonal());
    }
}

TEST(BilateralFilter, WrapsWhereTheFieldWraps) {
    const BilateralFilter filter{.radius_texels = 3, .tolerance_m = 0.3};
    const HeightField field = Rough(16, 9, Boundary::kWrap);
    EXPECT_EQ(Filtered(Shifted(field, 5, 4), filter).HeightsM(),
              Shifted(Filtered(field, filter), 5, 4).HeightsM());
}

// Expected: a mirrored field of n texels is one half of the wrapped field of 2 (n - 1) texels
// that repeats it backwards.
TEST(BilateralFilter, MirrorsWhereTheFieldIsMirrored) {
    const BilateralFilter filter{.radius_texels = 9, .tolerance_m = 0.5};
    const int n = 7;
    const HeightField half = Rough(n, n, Boundary::kMirror);
    Image<double> whole(2 * (n - 1), 2 * (n - 1));
    for (int j = 0; j < whole.Height(); ++j)
        for (int i = 0; i < whole.Width(); ++i)
            whole(i, j) = half.At(i < n ? i : 2 * (n - 1) - i, j < n ? j : 2 * (n - 1) - j);
    const HeightField expected = Filtered(HeightField(whole, 1, 1), filter);
    const HeightField out = Filtered(half, filter);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) EXPECT_EQ(out.At(i, j), expected.At(i, j));
}

TEST(BilateralFilter, NeverLeavesTheRangeOfTheField) {
    const HeightField field = Rough(20, 20, Boundary::kOpen);
    const HeightField out = Filtered(field, {.radius_texels = 2, .tolerance_m = 10});
    EXPECT_GT(out.LowestM(), field.LowestM());
    EXPECT_LT(out.HighestM(), field.HighestM());
}

TEST(BilateralFilter, RefusesBadParameters) {
    auto message = [](const BilateralFilter& filter) -> std::string {
        try {
            Validate(filter);
        } catch (const Error& e) {
            return e.what();
        }
        return "no error";
    };
    EXPECT_EQ(message({.radius_texels = -1, .tolerance_m = 1}),
              "BilateralFilter::radius_texels = -1, must be in [0, 64]");
    EXPECT_EQ(message({.radius_texels = 1}),
              "BilateralFilter::tolerance_m = 0, must be finite and > 0");
    EXPECT_THROW(Filtered(MakeFlat({}), {.tolerance_m = -1}), Error);
}

}  // namespace
}  // namespace plumb
