#include "jobs/light/simulate_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/parallel.h"
#include "core/statistics.h"
#include "formfactor/total.h"
#include "jobs/light/facet_scores.h"
#include "jobs/light/surface.h"
#include "tests/closed_forms/analytic_fields.h"

namespace plumb {
namespace {

SimulateSettings Brief() {
    SimulateSettings settings;
    settings.slices.slices = 8;
    settings.rays.rays = 64;
    return settings;
}

// Expected: rows close by construction, so light is neither lost nor made (furnace), by both
// ways to the links. Tolerance: the solver's residual 1e-10 times the mean number of bounces.
TEST(SimulateSurface, FurnaceHoldsByBothWays) {
    const Surface surface = LoadSurface("make:cobbles:32");
    for (const LinkMethod method : {LinkMethod::kSlices, LinkMethod::kRays}) {
        SimulateSettings settings = Brief();
        settings.method = method;
        const SurfaceLight light = SimulateSurface("cobbles", surface.field, settings);
        EXPECT_LE(light.figures.max_furnace_error, 1e-6);
        EXPECT_TRUE(light.series.settled);
    }
}

TEST(SimulateSurface, SameBitsOnOneThreadAndOnTwo) {
    const Surface surface = LoadSurface("make:gravel:32");
    std::vector<SurfaceLight> lights;
    for (const int threads : {1, 2}) {
        SetThreadCount(threads);
        lights.push_back(SimulateSurface("gravel", surface.field, Brief()));
    }
    SetThreadCount(0);
    EXPECT_EQ(lights[0].alpha, lights[1].alpha);
    EXPECT_EQ(lights[0].V, lights[1].V);
    EXPECT_EQ(lights[0].total, lights[1].total);
    for (std::size_t b = 0; b < lights[0].over_V.bins.size(); ++b) {
        const BounceBin &one = lights[0].over_V.bins[b], &two = lights[1].over_V.bins[b];
        EXPECT_EQ(one.count, two.count);
        for (std::size_t k = 0; k < one.bounce.size(); ++k) {
            EXPECT_EQ(one.bounce[k].mean, two.bounce[k].mean);
            EXPECT_EQ(one.bounce[k].p95, two.bounce[k].p95);
        }
    }
}

// Expected: the error stated beside the mean of V / n_z is how much that mean scatters from seed
// to seed. Tolerance: the scatter of 32 runs is itself sure to 1/sqrt(62), so 0.6 to 1.6 times
// are 3 of its errors; the waves are smooth, so neighbours differ by chance alone.
TEST(SimulateSurface, StatesTheErrorOfTheApertureIdentity) {
    const HeightField waves = MakeSinusoid(
        {.amplitude_m = 0.2, .periods_y = 1, .width_texels = 48, .height_texels = 48});
    Moments means;
    double stated = 0;
    constexpr int kRuns = 32;
    for (int run = 0; run < kRuns; ++run) {
        SimulateSettings settings = Brief();
        settings.method = LinkMethod::kRays;
        settings.rays.seed = std::uint64_t(run) + 1;
        settings.bounces = 0;
        const SurfaceLight light = SimulateSurface("waves", waves, settings);
        means.Add(light.figures.aperture->value);
        stated += light.figures.aperture->standard_error / kRuns;
    }
    const double scatter = means.StandardError() * std::sqrt(double(kRuns));
    EXPECT_GT(stated, 0.6 * scatter);
    EXPECT_LT(stated, 1.6 * scatter);
    EXPECT_NEAR(means.Mean(), 1, 4 * means.StandardError());
}

// Expected: alpha = V = 1 and no bounce, exactly: a flat field hides nothing.
TEST(SimulateSurface, FlatGroundSeesOnlySky) {
    const SurfaceLight light =
        SimulateSurface("flat", MakeFlat({.width_texels = 8, .height_texels = 8}), Brief());
    EXPECT_EQ(light.links, 0);
    EXPECT_EQ(light.figures.mean_alpha, 1);
    EXPECT_EQ(light.figures.mean_V, 1);
    EXPECT_EQ(light.figures.mean_first_bounce, 0);
    EXPECT_EQ(light.over_alpha.bins.back().count, light.figures.facets);
}

// Expected: the totals of the series are those of the linear system. Tolerance: the series stops
// when a total moves by less than 1e-5, with ratios of at most 0.9 behind it: 1e-5 / (1 - 0.9).
TEST(SimulateSurface, TotalsAreThoseOfTheLinearSystem) {
    const Surface surface = LoadSurface("make:bricks:32");
    SimulateSettings settings = Brief();
    settings.albedos = {0.5, 0.95};
    int seen = 0;
    const auto compare = [&](const Links& links, const FacetPieces& pieces) {
        ASSERT_GT(pieces.Count(), pieces.Facets());
        const SurfaceLight again = SimulateSurface("bricks", surface.field, settings);
        for (std::size_t r = 0; r < settings.albedos.size(); ++r) {
            const std::vector<double> albedo(links.V.size(), settings.albedos[r]);
            const TotalLight solved = SolveTotal(links, albedo);
            ASSERT_TRUE(solved.converged);
            const std::vector<double> E = pieces.FacetMeans(std::span<const double>(solved.E));
            for (std::size_t i = 0; i < E.size(); ++i) {
                EXPECT_NEAR(again.total[r][i], E[i], 1e-4);
            }
            ++seen;
        }
    };
    SimulateSurface("bricks", surface.field, settings, SilentMonitor(), nullptr, {},
                    {.links = compare});
    EXPECT_EQ(seen, 2);
}

TEST(FurnaceFault, IsSaidAboveTheLimitAndForWhatIsNoNumber) {
    EXPECT_EQ(FurnaceFault("wall", 1e-6), "");
    EXPECT_EQ(FurnaceFault("wall", kFurnaceLimit), "");
    for (const double error : {1.001e-3, 1e25, std::nan("")}) {
        EXPECT_NE(FurnaceFault("wall", error).find("wall: furnace error"), std::string::npos);
    }
}

// Expected: knowing more never raises the floor; the tolerance is the spread that the wider bins of
// the grid over both (1/24) carry: slope 1 times width / sqrt(12).
TEST(FloorsOf, BothVisibilitiesKnowMoreThanEither) {
    const Surface surface = LoadSurface("make:stone_wall:48");
    const Floors floors = FloorsOf(SimulateSurface("wall", surface.field, Brief()));
    EXPECT_GT(floors.of_alpha, floors.of_V);
    EXPECT_LT(floors.of_both, floors.of_V + 1 / 24.0 / std::sqrt(12.0));
    EXPECT_GT(floors.of_both, 0);
}

}  // namespace
}  // namespace plumb
