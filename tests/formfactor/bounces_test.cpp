// The series of bounces and its closure, on matrices solved by hand and on deep pits.
#include "formfactor/bounces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/error.h"
#include "formfactor/make_links.h"
#include "formfactor/slice_links.h"
#include "formfactor/total.h"
#include "tests/closed_forms/analytic_fields.h"
#include "tests/formfactor/fields.h"

namespace plumb {
namespace {

// Two facets that see each other: F_01 = 3/4, F_10 = 1/2, so V = (1/4, 1/2). All dyadic.
Links TwoFacets() {
    struct Maker {
        FacetResult Make(std::int64_t i, LinkBlock& block) {
            LinkRow row = {{std::uint32_t(1 - i), i == 0 ? 0.75 : 0.5}};
            return {1, AppendRow(row, block), 0};
        }
    };
    return MakeLinks(
        2, [] { return Maker(); }, SilentMonitor());
}

std::vector<std::vector<double>> Bounces(const Links& links, int bounces) {
    std::vector<std::vector<double>> E;
    ForEachBounce(links, bounces, [&](int k, std::span<const double> E_k) {
        EXPECT_EQ(k, int(E.size()));
        E.emplace_back(E_k.begin(), E_k.end());
    });
    return E;
}

const auto kIgnore = [](int, std::span<const double>) {};

// Expected: E_{k+1} = F E_k by hand: (1/4, 1/2), (3/8, 1/8), (3/32, 3/16), ...; two bounces
// multiply by F_01 F_10 = 3/8.
TEST(ForEachBounce, TwoFacetsByHand) {
    const auto E = Bounces(TwoFacets(), 9);
    ASSERT_EQ(E.size(), 10u);
    for (int k = 0; k < 10; ++k) {
        const double power = std::pow(0.375, k / 2);
        EXPECT_DOUBLE_EQ(E[k][0], power * (k % 2 == 0 ? 0.25 : 0.375));
        EXPECT_DOUBLE_EQ(E[k][1], power * (k % 2 == 0 ? 0.5 : 0.125));
    }
}

TEST(ForEachBounce, NoBounceIsTheSkyAlone) {
    EXPECT_EQ(Bounces(TwoFacets(), 0).size(), 1u);
}

TEST(ForEachBounce, RefusesANegativeCount) {
    EXPECT_THROW(ForEachBounce(TwoFacets(), -1, kIgnore), Error);
}

// Expected: E(rho) of the same: (V_0 + 3/4 rho V_1) / (1 - 3/8 rho^2), and likewise. The light
// alternates between two unequal facets, the worst case of a closure by a ratio; after k
// bounces less than (3/8)^(k/2) is under way, 1e-8 at the tolerance given.
TEST(RunSeries, TwoFacetsByHand) {
    const std::vector<double> rho = {0, 0.25, 0.5, 0.9, 1};
    std::vector<std::vector<double>> E;
    const Series series = RunSeries(
        TwoFacets(), {.bounces = 3, .albedos = rho, .tolerance = 1e-7, .max_bounces = 200},
        [&](int, std::span<const double> E_k) { E.emplace_back(E_k.begin(), E_k.end()); });
    EXPECT_EQ(E.size(), 4u);
    EXPECT_DOUBLE_EQ(E[3][0], 0.375 * 0.375);
    EXPECT_TRUE(series.settled);
    for (std::size_t r = 0; r < rho.size(); ++r) {
        const double down = 1 - 0.375 * rho[r] * rho[r];
        // A float and the tolerance.
        EXPECT_NEAR(series.total[r][0], (0.25 + 0.75 * rho[r] * 0.5) / down, 2e-7);
        EXPECT_NEAR(series.total[r][1], (0.5 + 0.5 * rho[r] * 0.25) / down, 2e-7);
    }
}

// Where V is the same everywhere the closure is the exact rest: E = V / (1 - rho (1 - V)) from
// the first bounce on, and the series need not go on.
TEST(RunSeries, ClosesACavityAtOnce) {
    struct Maker {
        FacetResult Make(std::int64_t, LinkBlock& block) {
            LinkRow row = {{0, 0.5}, {1, 0.25}, {2, 0.125}};
            return {1, AppendRow(row, block), 0};
        }
    };
    const Links links = MakeLinks(
        3, [] { return Maker(); }, SilentMonitor());
    const std::vector<double> rho = {0.3, 0.8, 0.99, 1};
    const Series series = RunSeries(links, {.bounces = 0, .albedos = rho}, kIgnore);
    EXPECT_LE(series.bounces_run, 3);
    for (std::size_t r = 0; r < rho.size(); ++r) {
        // Float.
        EXPECT_NEAR(series.total[r][1], 0.125 / (1 - rho[r] * 0.875), 1e-7);
    }
}

// A facet that sees the sky nowhere and one that sees only the other: all light is under way
// once, then gone. R_k does not move at first, which must neither divide by zero nor end the
// series.
TEST(RunSeries, WaitsForLightThatComesLate) {
    struct Maker {
        FacetResult Make(std::int64_t i, LinkBlock& block) {
            LinkRow row;
            if (i < 3) row = {{std::uint32_t(i + 1), 1.0}};  // 0 sees 1 sees 2 sees 3 sees sky.
            return {1, AppendRow(row, block), 0};
        }
    };
    const Links links = MakeLinks(
        4, [] { return Maker(); }, SilentMonitor());
    const Series series = RunSeries(links, {.bounces = 8, .albedos = {0.5, 1}}, kIgnore);
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(series.total[0][i], float(std::pow(0.5, 3 - i)));
        EXPECT_EQ(series.total[1][i], 1.0F);
    }
    EXPECT_EQ(series.largest_under_way, 0);
}

// At albedo 1 all that is under way arrives: the total is 1 wherever the series is cut, also
// where nothing has moved yet (facet 0 of the same chain after one bounce).
TEST(RunSeries, IsWhiteWhereverItIsCut) {
    struct Maker {
        FacetResult Make(std::int64_t i, LinkBlock& block) {
            LinkRow row;
            if (i < 3) row = {{std::uint32_t(i + 1), 1.0}};
            return {1, AppendRow(row, block), 0};
        }
    };
    const Links links = MakeLinks(
        4, [] { return Maker(); }, SilentMonitor());
    const Series series =
        RunSeries(links, {.bounces = 0, .albedos = {1}, .max_bounces = 1}, kIgnore);
    EXPECT_EQ(series.total[0], std::vector<float>(4, 1.0F));
    EXPECT_FALSE(series.settled);
}

// Facets 1 and 2 are cavities of V = 0.2 and 0.8 on their own; facet 0, V = 1/2, sees both alike,
// so its first two terms are those of a cavity of V = 1/2 and its closure does not move by the
// second. It is none: E = 1/2 + rho/4 (0.2 / (1 - 0.8 rho) + 0.8 / (1 - 0.2 rho)).
TEST(RunSeries, IsNotFooledByTwoTermsThatFit) {
    struct Maker {
        FacetResult Make(std::int64_t i, LinkBlock& block) {
            LinkRow row = {{1, 0.25}, {2, 0.25}};
            if (i == 1) row = {{1, 0.8}};
            if (i == 2) row = {{2, 0.2}};
            return {1, AppendRow(row, block), 0};
        }
    };
    const Links links = MakeLinks(
        3, [] { return Maker(); }, SilentMonitor());
    const double rho = 0.9;
    const Series series = RunSeries(links, {.bounces = 0, .albedos = {rho}}, kIgnore);
    const double E = 0.5 + rho / 4 * (0.2 / (1 - 0.8 * rho) + 0.8 / (1 - 0.2 * rho));
    // Later moves shrink by rho: 1e-5 rho / (1 - rho).
    EXPECT_NEAR(series.total[0][0], E, 1e-4);
}

// A cone 18 wide and 90 deep: light that has gone far down comes back after tens of bounces.
// Expected: what the Krylov solver says, itself good to its residual of 1e-10. Once the ratio q
// of the closure has settled, no move of a total is larger than rho times the one before it: if
// the last was 1e-5, all later ones are 1e-5 rho / (1 - rho) together. At rho = 1 the closure
// is all that is under way: a float's rounding.
TEST(RunSeries, AgreesWithTheSolverInADeepPit) {
    Image<double> heights(22, 22);
    for (int j = 0; j < 22; ++j) {
        for (int i = 0; i < 22; ++i) {
            heights(i, j) = -10 * std::max(0.0, 9 - std::hypot(i - 11, j - 11));
        }
    }
    const HeightField pit(std::move(heights), 1, 1);
    const Links links = LinksBySlices(pit, {.slices = 32});
    const std::vector<double> rho = {0.5, 0.8, 0.95, 1};
    const Series series =
        RunSeries(links, {.bounces = 20, .albedos = rho, .tolerance = 1e-5}, kIgnore);
    EXPECT_TRUE(series.settled);
    EXPECT_LE(series.last_move, 1e-5);
    EXPECT_GT(series.bounces_run, 40);  // The pit is deep.
    for (std::size_t r = 0; r < rho.size(); ++r) {
        const std::vector<double> albedo(links.V.size(), rho[r]);
        const TotalLight solved = SolveTotal(links, albedo);
        ASSERT_TRUE(solved.converged);
        double worst = 0;
        for (std::size_t i = 0; i < links.V.size(); ++i) {
            worst = std::max(worst, std::abs(series.total[r][i] - solved.E[i]));
        }
        const double later = rho[r] < 1 ? 1e-5 * rho[r] / (1 - rho[r]) : 0;
        EXPECT_LE(worst, later + 1e-7) << "rho " << rho[r];
    }
}

// What is said to be still under way is what the bounces leave: 1 - (E_0 + ... + E_k).
TEST(RunSeries, SaysHowMuchIsUnderWay) {
    const Links links = LinksBySlices(RoughField(8, 8, 6), {.slices = 16});
    std::vector<double> rest(links.V.size(), 1);
    const Series series =
        RunSeries(links, {.bounces = 12, .albedos = {}}, [&](int, std::span<const double> E_k) {
            for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= E_k[i];
        });
    EXPECT_EQ(series.bounces_run, 12);
    EXPECT_EQ(series.largest_under_way, *std::max_element(rest.begin(), rest.end()));
    EXPECT_TRUE(series.total.empty());
}

TEST(SeriesOptions, AreRefusedByNameValueAndRule) {
    const auto with = [](auto change) {
        SeriesOptions options;
        change(options);
        return MessageOf([&] { Validate(options); });
    };
    EXPECT_EQ(with([](auto&) {}), "no error");
    EXPECT_EQ(with([](auto& o) { o.bounces = -1; }),
              "SeriesOptions::bounces = -1, must be in [0, 1000]");
    EXPECT_EQ(with([](auto& o) {
                  o.albedos = {0.5, 1.5};
              }),
              "SeriesOptions::albedos = 1.5, must be in [0, 1]");
    EXPECT_EQ(with([](auto& o) { o.albedos = {std::numeric_limits<double>::quiet_NaN()}; }),
              "SeriesOptions::albedos = nan, must be in [0, 1]");
    EXPECT_EQ(with([](auto& o) { o.tolerance = 0; }),
              "SeriesOptions::tolerance = 0, must be in (0, 1)");
    EXPECT_EQ(with([](auto& o) { o.max_bounces = 0; }),
              "SeriesOptions::max_bounces = 0, must be in [1, 100000]");
}

// Expected, by hand with albedos a and b: E_0 = V_0 + F_01 b E_1, E_1 = V_1 + F_10 a E_0.
TEST(SolveTotal, TwoFacetsOfTwoAlbedosByHand) {
    const Links links = TwoFacets();
    for (const auto& [a, b] : {std::pair(0.0, 0.0), std::pair(0.0, 1.0), std::pair(1.0, 0.0),
                               std::pair(0.25, 0.75), std::pair(1.0, 1.0)}) {
        const TotalLight light = SolveTotal(links, std::vector<double>{a, b});
        const double down = 1 - 0.75 * b * 0.5 * a;
        EXPECT_TRUE(light.converged);
        EXPECT_NEAR(light.E[0], (0.25 + 0.75 * b * 0.5) / down, 1e-10);
        EXPECT_NEAR(light.E[1], (0.5 + 0.5 * a * 0.25) / down, 1e-10);
    }
}

// The solver's own word for its residual, held against the equation written out.
TEST(SolveTotal, StatesItsResidual) {
    const Links links = LinksBySlices(RoughField(8, 8, 6), {.slices = 16});
    std::vector<double> albedo(links.V.size());
    for (std::size_t i = 0; i < albedo.size(); ++i) albedo[i] = RandomUnit(7, i, 0, 0);
    for (const double tolerance : {1e-3, 1e-10}) {
        const TotalLight light = SolveTotal(links, albedo, tolerance);
        double square = 0, norm = 0;
        for (std::int64_t i = 0; i < links.Facets(); ++i) {
            double E = links.V[i];
            for (const auto& [j, F] : RowOf(links, i)) E += F * albedo[j] * light.E[j];
            square += (E - light.E[i]) * (E - light.E[i]);
            norm += links.V[i] * links.V[i];
        }
        // Roundings of 1e-16 a facet, besides.
        EXPECT_NEAR(light.residual, std::sqrt(square / norm), 1e-15);
        EXPECT_TRUE(light.converged);
        EXPECT_LE(light.residual, 10 * tolerance);
    }
}

TEST(SolveTotal, BlackGroundSeesTheSkyAlone) {
    const Links links = LinksBySlices(RoughField(6, 6, 3), {.slices = 8});
    const TotalLight light = SolveTotal(links, std::vector<double>(links.V.size(), 0.0));
    EXPECT_TRUE(light.converged);
    EXPECT_EQ(light.E, links.V);
}

TEST(SolveTotal, RefusesAlbedosThatAreNone) {
    const Links links = TwoFacets();
    const auto with = [&](std::vector<double> albedo) {
        return MessageOf([&] { SolveTotal(links, albedo); });
    };
    EXPECT_EQ(with({0.5, 0.5}), "no error");
    EXPECT_EQ(with({0.5, 1.25}), "albedo = 1.25, must be in [0, 1]");
    EXPECT_EQ(with({-0.5, 0.5}), "albedo = -0.5, must be in [0, 1]");
    EXPECT_EQ(with({0.5, std::numeric_limits<double>::quiet_NaN()}),
              "albedo = nan, must be in [0, 1]");
    EXPECT_EQ(with({0.5}), "albedo: 1 values for 2 facets, must be one a facet");
}

}  // namespace
}  // namespace plumb
