// The edge table: exact coverage, closed forms along the axes, and the order of the methods.
#include "screen_space/antialiasing/edge_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/parallel.h"

namespace plumb {
namespace {

constexpr double kPi = std::numbers::pi;

// Expected: a midpoint rule of 200 x 200 points; each column of points is off by half a step of
// 1/200 at most, at each of the two edges.
TEST(StripCoverage, IsTheAreaByCounting) {
    int partly = 0;
    for (const double degrees : {0.0, 7.0, 45.0, 80.0, 90.0, 133.0, 181.0, 270.0, 300.0}) {
        for (const double width : {0.3, 1.2, HUGE_VAL}) {
            const Strip strip{.middle_px = {2, 2},
                              .normal = UnitNormal(degrees * kPi / 180),
                              .low_px = -0.37,
                              .high_px = -0.37 + width};
            for (int j = 0; j < 4; ++j) {
                for (int i = 0; i < 4; ++i) {
                    int inside = 0;
                    for (int k = 0; k < 200 * 200; ++k) {
                        inside += strip.Covers(
                            {i + (k % 200 + 0.5) / 200, j + (k / 200 + 0.5) / 200});
                    }
                    const double exact = strip.Coverage(i, j);
                    EXPECT_NEAR(exact, inside / 40000.0, 1.0 / 200) << degrees << " " << width;
                    partly += exact > 0.01 && exact < 0.99;
                }
            }
        }
    }
    EXPECT_GT(partly, 100);
}

TEST(StripCoverage, TwoSidesMakeOneAndBarsAddUp) {
    for (int degrees = 0; degrees < 360; degrees += 11) {
        const double angle = degrees * kPi / 180;
        const Strip one{.middle_px = {0, 0}, .normal = UnitNormal(angle), .low_px = 0.2};
        const Strip other{
            .middle_px = {0, 0}, .normal = UnitNormal(angle + kPi), .low_px = -0.2};
        const Strip bar{
            .middle_px = {0, 0}, .normal = UnitNormal(angle), .low_px = -0.4, .high_px = 0.2};
        const Strip both{.middle_px = {0, 0}, .normal = UnitNormal(angle), .low_px = -0.4};
        for (int i = -2; i < 2; ++i) {
            EXPECT_NEAR(one.Coverage(i, 0) + other.Coverage(i, 0), 1, 1e-12);
            EXPECT_NEAR(one.Coverage(i, 0) + bar.Coverage(i, 0), both.Coverage(i, 0), 1e-12);
        }
    }
}

// The four directions of the axes: one of the three pixels near the edge in each row is cut, with
// the share c, every c equally often; m samples a column miss it by at most 1/(2m), uniformly:
// mean square 1/(12 m^2) of one in three, RMS 1/(6m). With 64 offsets the midpoint rule makes the
// mean square of each part of 64/m points less by the factor 1 - (m/64)^2 (odd m: not more than
// that); and edges that run through samples exactly, where m divides them, cost no more.
EdgeTableOptions Axes() {
    return {.angles = 4, .offsets = 64, .inner_px = 16, .band_px = 1.5};
}

TEST(EdgeError, OfGridsAlongTheAxesIsOneSixthOfTheirSpacing) {
    for (int m = 1; m <= 8; ++m) {
        const CoverageError error = EdgeError(GridCoverage(m), Axes());
        EXPECT_NEAR(error.rms, 1.0 / (6 * m),
                    1.0 / (6 * m) * std::pow(m / 64.0, 2) * 1.01 + 1e-9)
            << m;
        EXPECT_EQ(error.pixels, 4 * 64 * 16 * 3);
        EXPECT_EQ(error.samples, m * m);
        EXPECT_LE(error.largest, 0.5 / m + 1e-9);
        EXPECT_NEAR(error.bias, 0, 1e-3);
    }
    EXPECT_NEAR(EdgeError(OneSampleCoverage(), Axes()).rms, 1.0 / 6, 1e-4);
}

// A bar of w <= 1/2 px along an axis at an even offset: v = 1 where it covers the centre (share w of
// offsets), C = w where it lies within the pixel (share 1 - w), and C falls linearly to 0 over w on
// both sides. Int (v - C)^2 = w (1 - w)^2 + (1 - 2w) w^2 + 2 w^3 / 3, over 3 + w pixels.
// Tolerance: 64 offsets, the steps of v are met to 1/128 of a pixel: 2/128 of the integral's w.
TEST(BarError, OfOneSampleAlongTheAxes) {
    for (const double w : {0.1, 0.25, 0.5}) {
        const CoverageError error = BarError(OneSampleCoverage(), w, Axes());
        const double integral = w * (1 - w) * (1 - w) + (1 - 2 * w) * w * w + 2 * w * w * w / 3;
        EXPECT_NEAR(error.rms * error.rms * double(error.pixels) / (4 * 64 * 16), integral,
                    2.0 / 128)
            << w;
        EXPECT_NEAR(double(error.pixels) / (4 * 64 * 16), 3 + w, 2.0 / 64);
        EXPECT_NEAR(error.kept, 1, 2.0 / 128 / w);
    }
}

// Every pixel that the edge cuts has a mixed window or a plain one: with c = m^2 the normals ask
// for all samples of a mixed one, and one is enough for the others.
TEST(EdgeError, OfAdaptiveGridsIsThatOfTheGrid) {
    const EdgeTableOptions few{.angles = 7, .offsets = 8};
    for (const int m : {2, 3, 4}) {
        SampleMetrics metrics;
        metrics.normals.c = m * m;
        const CoverageError adaptive = EdgeError(AdaptiveCoverage("a", m, metrics), few);
        const CoverageError grid = EdgeError(GridCoverage(m), few);
        EXPECT_EQ(adaptive.rms, grid.rms);
        EXPECT_EQ(adaptive.bias, grid.bias);
        EXPECT_LT(adaptive.samples, 0.99 * m * m);
        metrics.use_depth = metrics.use_normals = false;
        metrics.shading.c = m * m;
        EXPECT_LE(EdgeError(AdaptiveCoverage("s", m, metrics), few).rms, grid.rms * 1.5);
    }
}

const EdgeRow& RowOf(const std::vector<EdgeRow>& rows, const std::string& method) {
    for (const EdgeRow& row : rows) {
        if (row.method == method) return row;
    }
    throw Error("no row " + method);
}

// Laws: every filter is nearer than one sample, more samples are nearer, a longer search is no
// farther; bars are listed as asked. 37 angles: those of the axes, where no filter helps, are few.
TEST(EdgeTable, OrdersTheMethods) {
    const std::vector<double> widths{0.5, 1};
    const std::vector<EdgeRow> rows =
        EdgeTable(CoverageMethods(), widths, {.angles = 37, .offsets = 4});
    EXPECT_EQ(rows.size(), 1u + 17 + 4 + 7 + 6);
    const double one = RowOf(rows, "1 sample").edge.rms;
    for (const EdgeRow& row : rows) {
        EXPECT_EQ(row.bars.size(), 2u);
        EXPECT_EQ(row.edge.rms_by_angle.size(), 37u);
        EXPECT_GT(row.edge.pixels, 37 * 4 * 16);
        EXPECT_LE(row.edge.rms, row.method == "1 sample" ? one : 0.99 * one) << row.method;
    }
    const auto rms = [&](const char* method) { return RowOf(rows, method).edge.rms; };
    EXPECT_LT(rms("grid 4"), rms("grid 2"));
    EXPECT_LT(rms("grid 8"), rms("grid 4"));
    EXPECT_LT(rms("smaa ultra"), rms("smaa low"));
    EXPECT_LT(rms("fxaa 39"), rms("fxaa 10"));
    EXPECT_LT(rms("grid 8"), rms("smaa ultra"));
}

TEST(EdgeTable, IsTheSameOnAnyNumberOfThreads) {
    const std::vector<CoverageMethod> methods = CoverageMethods();
    const EdgeTableOptions few{.angles = 5, .offsets = 2};
    SetThreadCount(1);
    std::vector<double> one;
    for (const CoverageMethod& method : methods) one.push_back(EdgeError(method, few).rms);
    SetThreadCount(4);
    for (std::size_t i = 0; i < methods.size(); ++i) {
        EXPECT_EQ(EdgeError(methods[i], few).rms, one[i]) << methods[i].name;
    }
    SetThreadCount(0);
}

// What lies beyond a method's margin does not change the pixels that are judged. Slow slopes have
// runs longer than any search, and each phase of the grid puts their ends elsewhere.
TEST(CoverageMethods, DependOnNothingBeyondTheirMargin) {
    for (const CoverageMethod& method : CoverageMethods()) {
        for (const double degrees : {0.6, 31.0, 89.2}) {
            for (int phase = 0; phase < 16; ++phase) {
                const auto draw = [&](int more) {
                    const int size = 8 + 2 * (method.margin_px + more);
                    const Strip strip{.middle_px = {size / 2.0, size / 2.0},
                                      .normal = UnitNormal(degrees * kPi / 180),
                                      .low_px = (phase + 0.3) / 16};
                    return method.draw(strip, size);
                };
                const CoveragePicture tight = draw(0), wide = draw(9);
                for (int y = 0; y < 8; ++y) {
                    for (int x = 0; x < 8; ++x) {
                        const int t = method.margin_px, w = t + 9;
                        EXPECT_EQ(tight.value(x + t, y + t), wide.value(x + w, y + w))
                            << method.name << " " << degrees;
                    }
                }
            }
        }
    }
}

// Strips at the offsets and angles that the header says, seen by a method that only looks.
TEST(EdgeTable, DrawsTheStripsThatItSays) {
    std::vector<Strip> seen;
    const CoverageMethod looker{
        "looker", 3, [&](const Strip& strip, int size_px) {
            EXPECT_EQ(size_px, 5 + 2 * 3);
            seen.push_back(strip);
            return CoveragePicture{Image<float>(11, 11), Image<float>(11, 11)};
        }};
    SetThreadCount(1);
    const EdgeTableOptions few{.angles = 4, .offsets = 2, .inner_px = 5};
    EdgeError(looker, few);
    BarError(looker, 0.5, few);
    SetThreadCount(0);
    ASSERT_EQ(seen.size(), 16u);
    for (const Strip& strip : seen) EXPECT_EQ(strip.middle_px, Vec2(5.5, 5.5));
    EXPECT_EQ(seen[0].low_px, 0.25);
    EXPECT_EQ(seen[1].low_px, 0.75);
    EXPECT_TRUE(std::isinf(seen[1].high_px));
    EXPECT_NEAR(seen[2].normal.y(), 1, 1e-12);
    EXPECT_NEAR(seen[4].normal.x(), -1, 1e-12);
    EXPECT_EQ(seen[8].low_px, 0);
    EXPECT_EQ(seen[8].high_px, 0.5);
    EXPECT_EQ(seen[9].low_px, 0.5);
}

TEST(EdgeTable, RefusesWhatCannotBe) {
    EXPECT_THROW(EdgeError(OneSampleCoverage(), {.angles = 0}), Error);
    EXPECT_THROW(EdgeError(OneSampleCoverage(), {.offsets = 1025}), Error);
    EXPECT_THROW(EdgeError(OneSampleCoverage(), {.inner_px = 3}), Error);
    EXPECT_THROW(EdgeError(OneSampleCoverage(), {.band_px = 0}), Error);
    EXPECT_THROW(BarError(OneSampleCoverage(), 0), Error);
    EXPECT_THROW(BarError(OneSampleCoverage(), std::nan("")), Error);
    EXPECT_THROW(GridCoverage(9), Error);
    EXPECT_EQ(BarWidthsPx().size(), 20u);
    EXPECT_EQ(BarWidthsPx().front(), 0.1);
    EXPECT_EQ(BarWidthsPx().back(), 2);
}

}  // namespace
}  // namespace plumb
