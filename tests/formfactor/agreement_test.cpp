// Slices and rays are two ways to one answer; thinning, a coarser horizon and threads must not
// change it by more than they say.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/conventions.h"
#include "core/parallel.h"
#include "formfactor/bounces.h"
#include "formfactor/ray_links.h"
#include "formfactor/slice_links.h"
#include "tests/closed_forms/analytic_fields.h"
#include "tests/closed_forms/trench.h"
#include "tests/formfactor/fields.h"

namespace plumb {
namespace {

// What a maker says of a facet that another can be held against: alpha, V, E_1, and how much of
// its hemisphere lies in the facets whose number is 0, 1, 2, 3 modulo 4.
constexpr int kFigures = 7;
const char* const kNames[kFigures] = {"alpha", "V", "E_1", "F_0", "F_1", "F_2", "F_3"};

std::vector<std::array<double, kFigures>> Figures(const Links& links) {
    const std::vector<double> E_1 = Gather(links, links.V);
    std::vector<std::array<double, kFigures>> out(links.V.size());
    for (std::int64_t i = 0; i < links.Facets(); ++i) {
        auto& of = out[std::size_t(i)];
        of = {links.alpha[i], links.V[i], E_1[i], 0, 0, 0, 0};
        for (const auto& [j, F] : RowOf(links, i)) of[3 + j % 4] += F;
    }
    return out;
}

using Replicates = std::vector<std::array<Moments, kFigures>>;

template <class Make>
Replicates Replicate(int replicates, Make make) {
    Replicates out;
    for (std::uint64_t seed = 1; seed <= std::uint64_t(replicates); ++seed) {
        const auto figures = Figures(make(seed));
        out.resize(figures.size());
        for (std::size_t i = 0; i < figures.size(); ++i) {
            for (int k = 0; k < kFigures; ++k) out[i][k].Add(figures[i][k]);
        }
    }
    return out;
}

// Two means apart by more than chance at kLevel: Student's t with the lesser of the two degrees
// of freedom (Welch's are never fewer).
double ExcessOfTwo(const Moments& a, const Moments& b, double bias) {
    const double error = std::hypot(a.StandardError(), b.StandardError());
    const double t =
        StudentQuantile(1 - kLevel / 2, double(std::min(a.Count(), b.Count()) - 1));
    const double off = std::abs(a.Mean() - b.Mean()) - bias;
    return off <= 0 ? 0 : off / (t * error);
}

// Both are unbiased but for their normalisation: slices by the quadrature error of a smooth
// function (3e-4 at 64 slices on these slopes), rays by half a stratum, 1/N relative. A slice
// may end 1e-4 rad early (V: twice that).
TEST(SlicesAndRays, AgreeFacetByFacet) {
    const double bias = 3e-4 + 1.0 / 512 / 2 + 2e-4;
    for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror, Boundary::kOpen}) {
        for (const Diagonal diagonal : {Diagonal::kRising, Diagonal::kFalling}) {
            const HeightField field = RoughField(7, 6, 2.5, boundary, diagonal);
            const Replicates slices = Replicate(12, [&](std::uint64_t seed) {
                return LinksBySlices(field, {.slices = 64, .seed = seed});
            });
            const Replicates rays = Replicate(12, [&](std::uint64_t seed) {
                return LinksByRays(field, {.rays = 512, .seed = seed});
            });
            double error = 0;
            for (std::size_t i = 0; i < slices.size(); ++i) {
                for (int k = 0; k < kFigures; ++k) {
                    EXPECT_LE(ExcessOfTwo(slices[i][k], rays[i][k], bias), 1)
                        << kNames[k] << " of facet " << i << ": " << slices[i][k].Mean()
                        << " by slices, " << rays[i][k].Mean() << " by rays";
                    error = std::max(error, slices[i][k].StandardError());
                    error = std::max(error, rays[i][k].StandardError());
                }
            }
            // So small that a wrong sign or facet would show.
            EXPECT_LT(error, 0.01);
        }
    }
}

// Both distributions of rays estimate the same V and links (not alpha, see ray_links.h).
TEST(Rays, DistributionsAgree) {
    const HeightField field = RoughField(7, 6, 2.5);
    const auto by = [&](RayDistribution distribution) {
        return Replicate(12, [&](std::uint64_t seed) {
            return LinksByRays(field,
                               {.rays = 512, .seed = seed, .distribution = distribution});
        });
    };
    const Replicates uniform = by(RayDistribution::kUniform);
    const Replicates cosine = by(RayDistribution::kCosine);
    for (std::size_t i = 0; i < uniform.size(); ++i) {
        for (int k = 1; k < kFigures; ++k) {
            EXPECT_LE(ExcessOfTwo(uniform[i][k], cosine[i][k], 1.0 / 512), 1)
                << kNames[k] << " of facet " << i;
        }
        // alpha: 1 / cosine has infinite variance, and its sample mean is low by what lies
        // below the lowest of 512 cosines, some (1/512)^(1/2) of the hemisphere.
        EXPECT_NEAR(uniform[i][0].Mean(), cosine[i][0].Mean(), 0.05) << "facet " << i;
    }
}

// Directions of a set lie on the hemisphere with the distribution they are said to have: N of
// them have one each in N equal intervals of z (uniform) or of z^2 (cosine).
TEST(Rays, DirectionsFillTheirStrata) {
    for (const RayDistribution distribution :
         {RayDistribution::kUniform, RayDistribution::kCosine}) {
        const RayOptions options{.rays = 64, .seed = 5, .distribution = distribution};
        std::vector<int> heights(64), azimuths(8);
        for (std::uint32_t k = 0; k < 64; ++k) {
            const Vec3 d = RayDirection(options, 7, k);
            EXPECT_NEAR(d.norm(), 1, 1e-15);
            EXPECT_GT(d.z(), 0);
            if (distribution == RayDistribution::kUniform) {
                ++heights[std::size_t(std::min(63.0, d.z() * 64))];
                ++azimuths[std::size_t((std::atan2(d.y(), d.x()) / kPi + 1) * 4) % 8];
            }
        }
        if (distribution == RayDistribution::kUniform) {
            EXPECT_EQ(heights, std::vector<int>(64, 1));
            EXPECT_EQ(azimuths, std::vector<int>(8, 8));
        }
        EXPECT_NE(RayDirection(options, 7, 0), RayDirection(options, 8, 0));
    }
}

// Expected: alpha is the same number, V the same up to the rounding of two rows, and F is
// unbiased: the same within what replicates of the difference allow.
TEST(Thinning, KeepsVAndAlphaAndIsUnbiased) {
    const HeightField field = RoughField(12, 10, 6);
    for (const int most : {1, 2, 8}) {
        std::vector<std::array<Moments, kFigures>> apart(std::size_t(field.Facets()));
        std::int64_t kept = 0, all = 0;
        for (std::uint64_t seed = 1; seed <= 24; ++seed) {
            const Links full =
                LinksBySlices(field, {.slices = 8, .seed = seed, .links_per_slice = 1 << 20});
            const Links thin =
                LinksBySlices(field, {.slices = 8, .seed = seed, .links_per_slice = most});
            ASSERT_EQ(thin.alpha, full.alpha);
            const auto a = Figures(thin), b = Figures(full);
            for (std::size_t i = 0; i < a.size(); ++i) {
                ASSERT_NEAR(thin.V[i], full.V[i], 2 * kFloatRow);
                ASSERT_NEAR(thin.V[i] + RowSum(thin, std::int64_t(i)), 1, 1e-14);
                for (int k = 2; k < kFigures; ++k) apart[i][k].Add(a[i][k] - b[i][k]);
            }
            kept += thin.Count(), all += full.Count();
        }
        for (std::size_t i = 0; i < apart.size(); ++i) {
            for (int k = 2; k < kFigures; ++k) {
                EXPECT_LE(Excess(apart[i][k], 0, 4 * kFloatRow), 1)
                    << kNames[k] << " of facet " << i << ", " << most << " a slice";
            }
        }
        // A kept stretch or a run of drawn ones holds 1/most of what a slice sees, but the last
        // run: at most 2 most + 1 links a slice.
        EXPECT_LE(kept, std::int64_t(24) * field.Facets() * 8 * (2 * most + 1));
        if (most <= 2) {
            EXPECT_LT(kept, all);
        }
    }
}

// Expected: azimuths turned, and directions scrambled, anew for every facet, so that even 4
// slices or 16 rays have no bias: over 300 facets of a trench's floor that are alike but for
// their row, the mean of alpha is the closed form, within what their scatter allows. (On level
// facets the slices' totals are the same at any turn.) Fixed azimuths would be off by 0.02.
TEST(Facets, AreSampledIndependently) {
    const Trench trench{.width_texels = 4, .land_texels = 2, .rows = 300};
    const HeightField field = MakeTrench(trench);
    const Links slices = LinksBySlices(
        field, {.slices = 4, .origins = Origins::kCentroid, .horizon_tolerance_rad = 1e-6});
    const Links rays = LinksByRays(field, {.rays = 16, .origins = Origins::kCentroid});
    const double s = trench.SpacingM();
    for (int column = 0; column < 3; ++column) {
        for (int upper = 0; upper < 2; ++upper) {
            Moments alpha_slices, alpha_rays, V_rays;
            double t = 0;
            for (int j = 0; j < trench.rows; ++j) {
                const std::int64_t i = 2 * (std::int64_t(j) * field.CellsX() + column) + upper;
                t = FacetOf(field, i).CentroidM().x() + s / 2;  // From the rim on the left.
                alpha_slices.Add(slices.alpha[i]);
                alpha_rays.Add(rays.alpha[i]);
                V_rays.Add(rays.V[i]);
            }
            const double alpha = TrenchFloorUniformVisibility(1 + s, 1, t).value;
            EXPECT_LE(Excess(alpha_slices, alpha, 1e-6), 1);
            EXPECT_LE(Excess(alpha_rays, alpha, 0), 1);
            // Divided by a sum of 16 cosines: half a stratum.
            EXPECT_LE(Excess(V_rays, TrenchFloorVisibility(1 + s, 1, t).value, 1.0 / 32), 1);
            EXPECT_GT(alpha_slices.Variance(), 0);
            EXPECT_GT(alpha_rays.Variance(), 0);
        }
    }
}

// Runs of stretches on different facets: over many seeds each facet must be kept in proportion
// to its share, also the last of a run. One slice direction is looked at: the row of a facet at
// the foot of a rough slope, seen by 4 slices, one link each.
TEST(Thinning, KeepsEachFacetInProportion) {
    const HeightField field = RoughField(9, 8, 8);
    const std::int64_t facet = 70;
    std::vector<Moments> apart(std::size_t(field.Facets()));
    std::vector<int> kept(apart.size());
    for (std::uint64_t seed = 1; seed <= 600; ++seed) {
        // Only the one facet's row is looked at, but links are made of all.
        const SliceOptions full{.slices = 4, .seed = seed, .links_per_slice = 1 << 20};
        SliceOptions thin = full;
        thin.links_per_slice = 1;
        std::vector<double> difference(std::size_t(field.Facets()));
        for (const auto& [j, F] : RowOf(LinksBySlices(field, thin), facet)) difference[j] += F;
        for (const auto& [j, F] : RowOf(LinksBySlices(field, full), facet)) difference[j] -= F;
        for (std::size_t j = 0; j < apart.size(); ++j) {
            apart[j].Add(difference[j]);
            kept[j] += difference[j] > 0;
        }
    }
    int compared = 0;
    for (std::size_t j = 0; j < apart.size(); ++j) {
        // A facet that was rarely kept for a run has no normal mean yet.
        if (kept[j] < 25) continue;
        ++compared;
        EXPECT_LE(Excess(apart[j], 0, kFloatRow), 1) << "facet " << j;
    }
    EXPECT_GE(compared, 8);
}

// Expected: what is left of a slice is thinner than the tolerance, so a slice's share of solid
// angle, Int sin th dth, is too open by tol at most and never too closed, and alpha is that
// over a mean of 1; for V the mean of all slices is 1/2, so it is too open by 2 tol at most.
// The means are those of the slices' own sums, good to 2 % at 16 slices on these slopes. With
// walls of slope 60, much of what is seen lies far below the horizontal.
TEST(HorizonTolerance, BoundsTheErrorOfAlphaAndV) {
    for (const double amplitude : {0.5, 6.0, 60.0}) {
        for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror, Boundary::kOpen}) {
            SCOPED_TRACE(int(boundary));
            const HeightField field = RoughField(11, 9, amplitude, boundary);
            const Links fine =
                LinksBySlices(field, {.slices = 16, .horizon_tolerance_rad = 1e-9});
            for (const double tolerance : {1e-3, 0.02, 0.1}) {
                const Links coarse =
                    LinksBySlices(field, {.slices = 16, .horizon_tolerance_rad = tolerance});
                double most = 0;
                for (std::size_t i = 0; i < fine.V.size(); ++i) {
                    const double d_alpha = coarse.alpha[i] - fine.alpha[i];
                    const double d_V = coarse.V[i] - fine.V[i];
                    ASSERT_GE(d_alpha, -1e-12) << "facet " << i;
                    ASSERT_LE(d_alpha, 1.02 * tolerance) << "facet " << i;
                    ASSERT_GE(d_V, -2 * kFloatRow) << "facet " << i;
                    ASSERT_LE(d_V, 2.04 * tolerance) << "facet " << i;
                    most = std::max(most, d_alpha);
                }
                if (tolerance == 0.1 && amplitude < 10) {
                    EXPECT_GT(most, 0);
                }
            }
        }
    }
}

// The sharpest case: a wall a little higher right behind the wall that is seen first, the same
// on either side, seen by four slices that all cross at 45 degrees. Whatever the tolerance, it
// may cost no more than it says; three times as much would pass the bound at some of these.
TEST(HorizonTolerance, IsNotExceededByAWallBehindAWall) {
    Image<double> heights(41, 3);
    for (int j = 0; j < 3; ++j) {
        heights(18, j) = heights(22, j) = 0.8;
        heights(19, j) = heights(20, j) = heights(21, j) = 1;
    }
    const HeightField field(std::move(heights), 1, 1);
    const auto look = [&](double tolerance) {
        return LinksBySlices(field, {.slices = 4,
                                     .origins = Origins::kCentroid,
                                     .rotate = false,
                                     .horizon_tolerance_rad = tolerance});
    };
    const Links fine = look(1e-9);
    int coarser = 0;
    for (double tolerance = 1e-3; tolerance < 0.1; tolerance *= 1.1) {
        const Links coarse = look(tolerance);
        for (std::size_t i = 0; i < fine.V.size(); ++i) {
            if (fine.alpha[i] == 1) continue;
            // Level floor: at 4 slices the totals are 4 exactly.
            ASSERT_LE(coarse.alpha[i] - fine.alpha[i], tolerance) << "facet " << i;
            coarser += coarse.alpha[i] > fine.alpha[i] + 1e-12;
        }
    }
    EXPECT_GT(coarser, 0);
}

// A line that does not rise meets an endless field, however early it is given up: alpha is at
// most the share of the hemisphere above the horizontal, Sum (1 - cos min(th_max, pi/2)) over
// Sum (1 - cos th_max). On a nearly level field, at the coarsest tolerance, most downward looks
// are given up before they meet anything; their share is stated.
TEST(HorizonTolerance, GivesNothingBelowTheHorizontalToTheSky) {
    const int slices = 16;
    for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror}) {
        for (const double amplitude : {0.03, 0.3, 3.0}) {
            const HeightField field = RoughField(11, 9, amplitude, boundary);
            const Links links = LinksBySlices(
                field, {.slices = slices, .rotate = false, .horizon_tolerance_rad = 0.1});
            double below_mean = 0;
            for (std::int64_t i = 0; i < field.Facets(); ++i) {
                const Vec3 n = FacetOf(field, i).normal;
                double above = 0, all = 0;
                for (int k = 0; k < slices; ++k) {
                    const double phi = 2 * kPi * (k + 0.5) / slices;
                    const double c = n.x() * std::cos(phi) + n.y() * std::sin(phi);
                    const double th = kPi / 2 + std::atan2(c, n.z());
                    above += 1 - std::cos(std::min(th, kPi / 2));
                    all += 1 - std::cos(th);
                }
                ASSERT_LE(links.alpha[i], above / all + 1e-12) << "facet " << i;
                below_mean += (1 - above / all) / double(field.Facets());
            }
            EXPECT_GE(links.mean_cut_short, 0);
            if (amplitude < 0.1) {
                EXPECT_GT(links.mean_cut_short, 0);
                EXPECT_LT(links.mean_cut_short, below_mean);
            }
        }
    }
}

// What lies below the horizontal is given to the facet last seen, never to the sky, and its
// share is stated. At the default tolerance of 1e-4 it is at most that thin in a slice.
TEST(HorizonTolerance, CutsHardlyAnythingShort) {
    for (const double amplitude : {0.5, 6.0, 60.0}) {
        for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror}) {
            const HeightField field = RoughField(11, 9, amplitude, boundary);
            EXPECT_LE(LinksBySlices(field).mean_cut_short, 2e-4);
            EXPECT_LE(LinksByRays(field, {.rays = 256}).mean_cut_short, 1e-5);
        }
    }
}

// Along a groove a level ray never meets anything: what is lost so must be counted.
TEST(Rays, CountWhatIsCutShort) {
    const HeightField groove = MakeVGroove({.opening_rad = 1, .texels_per_face = 6});
    const Links links = LinksByRays(groove, {.rays = 4096});
    EXPECT_LE(links.mean_cut_short, 1e-5);
    for (std::size_t i = 0; i < links.V.size(); ++i) EXPECT_LT(links.V[i], 1);
}

template <class Make>
void ExpectTheSameOnTwoThreads(Make make) {
    SetThreadCount(1);
    const Links one = make();
    const Series series_one = RunSeries(one, {.bounces = 5, .albedos = {0.3, 0.9}},
                                        [](int, std::span<const double>) {});
    SetThreadCount(2);
    const Links two = make();
    const Series series_two = RunSeries(two, {.bounces = 5, .albedos = {0.3, 0.9}},
                                        [](int, std::span<const double>) {});
    SetThreadCount(0);
    EXPECT_EQ(one.alpha, two.alpha);
    EXPECT_EQ(one.V, two.V);
    EXPECT_EQ(one.mean_cut_short, two.mean_cut_short);
    ASSERT_EQ(one.blocks.size(), two.blocks.size());
    for (std::size_t b = 0; b < one.blocks.size(); ++b) {
        EXPECT_EQ(one.blocks[b].row_begin, two.blocks[b].row_begin);
        EXPECT_EQ(one.blocks[b].facet, two.blocks[b].facet);
        EXPECT_EQ(one.blocks[b].weight, two.blocks[b].weight);
    }
    EXPECT_EQ(series_one.total, series_two.total);
    EXPECT_EQ(series_one.bounces_run, series_two.bounces_run);
    EXPECT_EQ(series_one.last_move, series_two.last_move);
}

TEST(Threads, DoNotChangeABit) {
    const HeightField field = RoughField(50, 45, 5);  // 4500 facets: five blocks.
    ExpectTheSameOnTwoThreads([&] { return LinksBySlices(field, {.slices = 8}); });
    ExpectTheSameOnTwoThreads([&] { return LinksByRays(field, {.rays = 16}); });
}

}  // namespace
}  // namespace plumb
