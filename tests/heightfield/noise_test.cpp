// The random numbers and patterns that the generators are made of.
#include "heightfield/procedural/noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/vec.h"

namespace plumb {
namespace {

using namespace procedural;

// Expected: the first output of SplitMix64 from the state 0, as its authors publish it.
TEST(Noise, MixIsTheFinalizerOfSplitMix64) {
    EXPECT_EQ(Mix(0x9e3779b97f4a7c15u), 0xe220a8397b1dcdafu);
}

// chi^2 of 256 bins has mean 255 and standard deviation sqrt(2 255) = 22.6; 4 of these on
// either side, for each argument counted up alone.
TEST(Noise, UniformIsUniformInEveryArgument) {
    const int draws = 1 << 16;
    for (int argument = 0; argument < 4; ++argument) {
        std::vector<int> bins(256);
        for (int k = 0; k < draws; ++k) {
            const double u = argument == 0   ? Uniform(k, 0, 0, 0)
                             : argument == 1 ? Uniform(0, k, 0, 0)
                             : argument == 2 ? Uniform(0, 0, k, 0)
                                             : Uniform(0, 0, 0, k);
            ++bins[int(u * 256)];
        }
        double chi2 = 0;
        for (const int n : bins) chi2 += std::pow(n - draws / 256.0, 2) / (draws / 256.0);
        EXPECT_NEAR(chi2, 255, 4 * std::sqrt(2 * 255)) << argument;
    }
}

// Expected: by definition 0 at the nodes; |n| <= 1 from the bound of the header; and it is not
// idle: random gradients reach beyond 0.5.
TEST(Noise, GradientNoiseIsBoundedAndZeroAtNodes) {
    double largest = 0;
    for (int j = 0; j < 256; ++j) {
        for (int i = 0; i < 256; ++i) {
            const double n = GradientNoise(3, 1, (i + 0.5) / 256, (j + 0.5) / 256, 32, 16);
            largest = std::max(largest, std::abs(n));
        }
    }
    EXPECT_LE(largest, 1);
    EXPECT_GE(largest, 0.5);
    for (int i = 0; i < 32; ++i)
        for (int j = 0; j < 16; ++j)
            EXPECT_EQ(GradientNoise(3, 1, i / 32.0, j / 16.0, 32, 16), 0);
}

// Expected: without jitter the sites stand in the middle of square cells: by hand.
TEST(Noise, NearestSiteOfASquareGrid) {
    const CellPoint p = NearestSite(9, 1, 5.25 / 8, 6.625 / 8, 8, 8, 0);
    EXPECT_EQ(p.i, 5);
    EXPECT_EQ(p.j, 6);
    EXPECT_DOUBLE_EQ(p.dx, -0.25);
    EXPECT_DOUBLE_EQ(p.dy, 0.125);
    EXPECT_DOUBLE_EQ(p.to_edge, 0.25);
    EXPECT_LT(p.to_rounded, p.to_edge);
}

// Expected: the sites of a 5 x 5 lattice, found one by one over 5 x 5 tiles, brute force.
TEST(Noise, NearestSiteAgreesWithBruteForce) {
    const int n = 5;
    std::vector<Vec2> sites;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            // A site is where dx = dy = 0: read it off from its own cell's middle.
            double u = (i + 0.5) / n, v = (j + 0.5) / n;
            const CellPoint p = NearestSite(2, 7, u, v, n, n, 0.9);
            sites.emplace_back(u * n - p.dx, v * n - p.dy);
        }
    }
    for (int k = 0; k < 500; ++k) {
        const double u = Uniform(1, 0, k, 0), v = Uniform(1, 0, k, 1);
        std::vector<double> distances;
        for (const Vec2& site : sites)
            for (int ty = -2; ty <= 2; ++ty)
                for (int tx = -2; tx <= 2; ++tx)
                    distances.push_back(
                        std::hypot(u * n - site.x() - tx * n, v * n - site.y() - ty * n));
        const CellPoint p = NearestSite(2, 7, u, v, n, n, 0.9);
        const double nearest = *std::min_element(distances.begin(), distances.end());
        EXPECT_NEAR(std::hypot(p.dx, p.dy), nearest, 1e-12);
        EXPECT_GE(p.to_edge, 0);
        EXPECT_LE(p.to_edge, kFarthestEdge);
    }
}

}  // namespace
}  // namespace plumb
