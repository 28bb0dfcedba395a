#include "score/regions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.h"
#include "tests/score/made_images.h"

namespace plumb {
namespace {

constexpr float kSky = -std::numeric_limits<float>::infinity();
const Vec3f kFront(0, 0, 1);

// A floor 1 m below the eye, drawn to 0.5 degrees below the horizon: z = -1 / slope of the
// row.
Image<float> GrazingFloor(int width, int height) {
    return MadeImage<float>(width, height, [&](int, int j) { return -1 / (0.01 + 0.02 * j); });
}

TEST(Regions, APlaneHasNoEdgeHoweverGrazing) {
    const Regions regions = FindRegions(GrazingFloor(20, 30), {}, {.depth_jump = 1e-4});
    EXPECT_EQ(CountOf(regions.edges), 0);
    EXPECT_EQ(CountOf(regions.interiors), 600);
    // Its depth doubles from the first row to the second: 1 / 0.01 against 1 / 0.03.
    EXPECT_LT(GrazingFloor(1, 2)(0, 0), 2 * GrazingFloor(1, 2)(0, 1));
}

// A step from 2 m to 2.1 m between columns 9 and 10: 5 % of the nearer, found if more than the
// share asked for; with a reach of 3 pixels columns 6 to 13.
TEST(Regions, FindAJumpOfDepthAndItsReach) {
    const auto z = MadeImage<float>(20, 4, [](int i, int) { return i < 10 ? -2 : -2.1; });
    const Regions regions = FindRegions(z, {}, {.depth_jump = 0.04, .reach_px = 3});
    for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(regions.edges(i, 1), 6 <= i && i <= 13) << i;
        EXPECT_EQ(regions.interiors(i, 1), !(6 <= i && i <= 13)) << i;
    }
    EXPECT_EQ(CountOf(FindRegions(z, {}, {.depth_jump = 0.06}).edges), 0);
}

// The silhouette against the sky, and the sky itself in no region.
TEST(Regions, SkyIsNotSeenAndItsBorderIsAnEdge) {
    const auto z = MadeImage<float>(8, 8, [](int, int j) { return j < 4 ? kSky : -3; });
    const Regions regions = FindRegions(z, {}, {.reach_px = 0, .border_px = 1});
    EXPECT_EQ(CountOf(regions.seen), 32);
    EXPECT_EQ(CountOf(regions.edges), 8);
    EXPECT_EQ(regions.edges(3, 4), 1);
    EXPECT_EQ(regions.edges(3, 3), 0);
    EXPECT_EQ(CountOf(regions.border), 2 * 4 + 6);
    EXPECT_EQ(CountOf(regions.centre), 32 - 14);
}

// Normals that turn by 30 degrees between rows 4 and 5.
TEST(Regions, FindATurnOfTheNormal) {
    const Image<float> z(6, 10, -1.0f);
    const double turn = std::numbers::pi / 6;
    Image<Vec3f> normal(6, 10, kFront);
    for (int j = 5; j < 10; ++j)
        for (int i = 0; i < 6; ++i)
            normal(i, j) = Vec3f(0, float(std::sin(turn)), float(std::cos(turn)));
    const RegionOptions finer{.normal_turn_rad = 0.9 * turn, .reach_px = 1};
    const Regions regions = FindRegions(z, normal, finer);
    for (int j = 0; j < 10; ++j) EXPECT_EQ(regions.edges(2, j), 3 <= j && j <= 6) << j;
    EXPECT_EQ(CountOf(FindRegions(z, normal, {.normal_turn_rad = 1.1 * turn}).edges), 0);
}

TEST(Regions, SplitWhatIsSeen) {
    const auto noise = CorrelatedNoise(40, 30, 2, 1, 0);
    const auto z = MadeImage<float>(
        40, 30, [&](int i, int j) { return noise(i, j) > 1.5 ? kSky : -5 - noise(i, j); });
    const Regions regions = FindRegions(z, {}, {.reach_px = 1, .border_px = 3});
    EXPECT_EQ(CountOf(regions.edges) + CountOf(regions.interiors), CountOf(regions.seen));
    EXPECT_EQ(CountOf(regions.border) + CountOf(regions.centre), CountOf(regions.seen));
    EXPECT_EQ(CountOf(Both(regions.edges, regions.interiors)), 0);
    EXPECT_EQ(Both({}, regions.edges), regions.edges);
    EXPECT_EQ(Both(regions.seen, regions.edges), regions.edges);
    EXPECT_GT(CountOf(regions.edges), 0);
}

TEST(Regions, ValidateTheirInput) {
    const Image<float> z(4, 4, -1.0f);
    EXPECT_THROW(FindRegions(z, {}, {.depth_jump = 0}), Error);
    EXPECT_THROW(FindRegions(z, {}, {.normal_turn_rad = 4}), Error);
    EXPECT_THROW(FindRegions(z, {}, {.reach_px = -1}), Error);
    EXPECT_THROW(FindRegions(z, {}, {.border_px = -1}), Error);
    EXPECT_THROW(FindRegions(z, Image<Vec3f>(3, 4, kFront)), Error);
    EXPECT_EQ(CountOf(FindRegions(Image<float>(1, 1, -1.0f), {}).seen), 1);
}

}  // namespace
}  // namespace plumb
