// The measurements of plumb bench truth, small: that they measure what they say.
#include "jobs/truth/bench_truth.h"

#include <gtest/gtest.h>

#include "core/parallel.h"

namespace plumb {
namespace {

// Expected: both ways cast the same rays, so they meet the same number of things; independent
// samples err by n^(-1/2), nets by less. The slope of 96 x 8 estimates over a factor of 256
// is known to about 0.02.
TEST(BenchTruth, ComparesTheSameRaysAndFindsTheSlopes) {
    TruthBenchSettings settings;
    settings.width_px = 96;
    settings.height_px = 64;
    settings.pixel_rows = 8;
    settings.rounds = 1;
    settings.furnace_paths = 0;
    settings.reference_rays = 65536;
    double now = 0;
    const TruthBench bench =
        BenchTruth(LoadScene("cornell_box"), settings, [&] { return now += 0.5; });
    SetThreadCount(0);
    EXPECT_GT(bench.receivers, 4 * 96);
    EXPECT_LE(bench.receivers, 8 * 96);
    EXPECT_EQ(bench.differing_rays, 0);
    ASSERT_EQ(bench.speeds.size(), 2u);
    for (const TruthSpeed& speed : bench.speeds) {  // Every clock interval is half a second.
        EXPECT_EQ(speed.share, 1);
        EXPECT_EQ(speed.rays_per_second, 2.0 * 64 * double(bench.receivers));
        EXPECT_EQ(speed.bare_stream_per_second, speed.rays_per_second);
    }
    EXPECT_NEAR(bench.convergence.slope_independent, -0.5, 0.06);
    EXPECT_LT(bench.convergence.slope_nets, -0.65);
    ASSERT_EQ(bench.convergence.points.size(), 5u);
    EXPECT_LT(bench.convergence.points.back().nets,
              bench.convergence.points.back().independent);
    EXPECT_EQ(bench.furnace.paths, 0);
    EXPECT_NE(ToJsonText(bench).find("\"slope_nets\""), std::string::npos);
}

}  // namespace
}  // namespace plumb
