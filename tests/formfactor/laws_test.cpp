// Laws that hold on any surface, whatever its shape: no reference is needed to see them broken.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/conventions.h"
#include "core/visibility.h"
#include "formfactor/bounces.h"
#include "formfactor/ray_links.h"
#include "formfactor/slice_links.h"
#include "formfactor/total.h"
#include "tests/closed_forms/analytic_fields.h"
#include "tests/formfactor/fields.h"

namespace plumb {
namespace {

const auto kIgnore = [](int, std::span<const double>) {};

// The same rough surface under every boundary, with either diagonal.
std::vector<HeightField> RoughFields(double amplitude_m) {
    std::vector<HeightField> fields;
    for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror, Boundary::kOpen}) {
        for (const Diagonal diagonal : {Diagonal::kRising, Diagonal::kFalling}) {
            fields.push_back(RoughField(10, 9, amplitude_m, boundary, diagonal));
        }
    }
    return fields;
}

// Fields x makers, coarse and fine.
std::vector<Links> AllLinks(double amplitude_m) {
    std::vector<Links> all;
    for (const HeightField& field : RoughFields(amplitude_m)) {
        for (const int slices : {16, 32})
            all.push_back(LinksBySlices(field, {.slices = slices}));
        for (const int rays : {64, 1024}) {
            all.push_back(LinksByRays(field, {.rays = rays}));
        }
        all.push_back(
            LinksByRays(field, {.rays = 128, .distribution = RayDistribution::kCosine}));
    }
    return all;
}

// Expected: V + Sum_j F_ij = 1. A sum of n <= 300 doubles below 1 rounds by n 2^-54 at most.
TEST(Laws, RowsClose) {
    for (const double amplitude : {0.5, 5.0, 100.0}) {
        for (const Links& links : AllLinks(amplitude)) {
            for (std::int64_t i = 0; i < links.Facets(); ++i) {
                ASSERT_NEAR(links.V[i] + RowSum(links, i), 1, 2e-14) << "facet " << i;
                ASSERT_GE(links.V[i], 0);
                ASSERT_GE(links.alpha[i], 0);
                ASSERT_LE(links.alpha[i], 1);
                for (const auto& [j, weight] : RowOf(links, i)) {
                    ASSERT_LT(j, links.Facets());
                    ASSERT_GE(weight, 0);
                }
            }
        }
    }
}

// No facet of a plane faces itself: what it links to itself is the image of it in another tile,
// which an open field has not.
TEST(Laws, NoFacetOfAnOpenFieldLinksToItself) {
    const HeightField field = RoughField(10, 9, 6, Boundary::kOpen);
    for (const Links& links : {LinksBySlices(field), LinksByRays(field)}) {
        for (std::int64_t i = 0; i < links.Facets(); ++i) {
            for (const auto& [j, weight] : RowOf(links, i)) ASSERT_NE(j, i);
        }
    }
}

// Expected: all that is white ends in the sky, so E = 1 on every facet. The solver's residual
// of 1e-10 is amplified by 1 / min(1 - lambda) of the operator, below 1e3 here.
TEST(Laws, TheFurnaceIsWhite) {
    for (const double amplitude : {0.5, 5.0}) {
        for (const Links& links : AllLinks(amplitude)) {
            const TotalLight light =
                SolveTotal(links, std::vector<double>(links.V.size(), 1.0));
            ASSERT_TRUE(light.converged);
            const Series series = RunSeries(links, {.bounces = 0, .albedos = {1}}, kIgnore);
            for (std::int64_t i = 0; i < links.Facets(); ++i) {
                ASSERT_NEAR(light.E[i], 1, 1e-6) << "facet " << i;
                ASSERT_NEAR(series.total[0][i], 1, 1e-6) << "facet " << i;
            }
        }
    }
}

// The same without the closure, which is exact at albedo 1 by construction: the E_k themselves
// sum to 1. The slowest mode of this field loses a tenth a bounce at least: 0.9^400 = 5e-19.
TEST(Laws, BouncesSumToOne) {
    for (const HeightField& field : RoughFields(3)) {
        for (const Links& links :
             {LinksBySlices(field, {.slices = 16}), LinksByRays(field, {.rays = 64})}) {
            std::vector<double> sum(links.V.size());
            ForEachBounce(links, 400, [&](int, std::span<const double> E_k) {
                for (std::size_t i = 0; i < sum.size(); ++i) {
                    ASSERT_GE(E_k[i], 0);
                    sum[i] += E_k[i];
                }
            });
            for (const double s : sum) ASSERT_NEAR(s, 1, 1e-6);
        }
    }
}

// Expected: E(rho) = Sum rho^k E_k has derivatives of every order >= 0. Solved to 1e-10, so
// second differences over steps of 0.1 are good to 1e-8.
TEST(Laws, LightIsMonotoneAndConvexInAlbedo) {
    for (const HeightField& field : RoughFields(5)) {
        const Links links = LinksBySlices(field);
        std::vector<std::vector<double>> E;
        for (int r = 0; r <= 10; ++r) {
            E.push_back(
                SolveTotal(links, std::vector<double>(links.V.size(), 0.1 * r), 1e-12).E);
        }
        for (std::size_t i = 0; i < links.V.size(); ++i) {
            for (int r = 1; r <= 10; ++r) {
                ASSERT_GE(E[r][i] - E[r - 1][i], -1e-8) << "facet " << i << ", rho " << 0.1 * r;
                if (r < 10) {
                    ASSERT_GE(E[r + 1][i] - 2 * E[r][i] + E[r - 1][i], -1e-8);
                }
            }
            ASSERT_NEAR(E[0][i], links.V[i], 1e-10);
        }
    }
}

// Patches: facets by the quarter of the tile that they lie in, along x and y: 16 of them.
constexpr int kPatches = 16;
int PatchOf(const HeightField& field, std::int64_t facet) {
    const int i = int(facet / 2 % field.CellsX()), j = int(facet / 2 / field.CellsX());
    return 4 * (4 * j / field.CellsY()) + 4 * i / field.CellsX();
}

// Sum_{i in P} A_i Sum_{j in Q} F_ij, in m2.
std::vector<double> Exchange(const HeightField& field, const Links& links) {
    std::vector<double> out(kPatches * kPatches);
    for (std::int64_t i = 0; i < links.Facets(); ++i) {
        const double A = FacetOf(field, i).area_m2;
        for (const auto& [j, F] : RowOf(links, i)) {
            out[std::size_t(PatchOf(field, i) * kPatches + PatchOf(field, j))] += A * F;
        }
    }
    return out;
}

// The most that the slices of any facet sum off pi, relatively: Sum_k G(th_max(phi_k)) 2 pi / N
// for the worst turn of the azimuths (of 64). What is given to a facet by dividing by that sum
// is off by as much: the quadrature error of the header, as a number.
double WorstQuadrature(const HeightField& field, int slices) {
    double worst = 0;
    for (std::int64_t i = 0; i < field.Facets(); ++i) {
        const Vec3 n = FacetOf(field, i).normal;
        for (int turn = 0; turn < 64; ++turn) {
            double sum = 0;
            for (int k = 0; k < slices; ++k) {
                const double phi = 2 * kPi * (k + turn / 64.0) / slices;
                const double c = n.x() * std::cos(phi) + n.y() * std::sin(phi);
                // The facet's plane, from the vertical.
                const double th = kPi / 2 + std::atan2(c, n.z());
                sum += c * (th - std::sin(th) * std::cos(th)) / 2 +
                       n.z() * std::sin(th) * std::sin(th) / 2;
            }
            worst = std::max(worst, std::abs(2 * sum / slices - 1));
        }
    }
    return worst;
}

// Expected: A_i F_ij = A_j F_ji, summed over patches, within what replicates allow and the bias
// of the quadrature (slices) or of the sum of N cosines (rays: half a stratum, 1/N).
TEST(Laws, ExchangeIsReciprocal) {
    const HeightField field = RoughField(12, 8, 4, Boundary::kWrap, Diagonal::kFalling);
    for (const bool by_slices : {true, false}) {
        const int slices = 32, rays = 128;
        std::vector<Moments> apart(kPatches * kPatches), size(kPatches * kPatches);
        for (std::uint64_t seed = 1; seed <= 16; ++seed) {
            const Links links = by_slices
                                    ? LinksBySlices(field, {.slices = slices, .seed = seed})
                                    : LinksByRays(field, {.rays = rays, .seed = seed});
            const std::vector<double> exchange = Exchange(field, links);
            for (int p = 0; p < kPatches; ++p) {
                for (int q = 0; q < kPatches; ++q) {
                    const double there = exchange[std::size_t(p * kPatches + q)];
                    const double back = exchange[std::size_t(q * kPatches + p)];
                    apart[std::size_t(p * kPatches + q)].Add(there - back);
                    size[std::size_t(p * kPatches + q)].Add(there);
                }
            }
        }
        const double relative = by_slices ? WorstQuadrature(field, slices) : 1.0 / rays;
        EXPECT_LT(relative, 0.02);
        int compared = 0;
        for (int p = 0; p < kPatches; ++p) {
            for (int q = 0; q < p; ++q) {
                const std::size_t pq = std::size_t(p * kPatches + q);
                if (size[pq].Mean() == 0) continue;
                ++compared;
                EXPECT_LE(Excess(apart[pq], 0, relative * size[pq].Mean()), 1)
                    << "patches " << p << ", " << q << (by_slices ? " slices" : " rays")
                    << apart[pq].Mean() << " of " << size[pq].Mean();
            }
        }
        EXPECT_GE(compared, 100);
    }
}

// Expected: what a periodic surface sees of the sky is what its outline on the plane would see,
// Sum_i A_i V_i = A_projected: the mean of V / n_z is 1. Chance: replicates. Bias: the
// quadrature's.
TEST(Laws, TheSurfaceSeesThroughItsAperture) {
    for (const double amplitude : {1.0, 6.0}) {
        for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror}) {
            const HeightField field = RoughField(10, 8, amplitude, boundary);
            std::vector<double> n_z;
            for (std::int64_t i = 0; i < field.Facets(); ++i) {
                n_z.push_back(FacetOf(field, i).normal.z());
            }
            Moments slices, rays;
            for (std::uint64_t seed = 1; seed <= 16; ++seed) {
                const auto mean = [&](const Links& links) {
                    double sum = 0;
                    for (std::size_t i = 0; i < n_z.size(); ++i) sum += links.V[i] / n_z[i];
                    return sum / double(n_z.size());
                };
                slices.Add(mean(LinksBySlices(field, {.slices = 32, .seed = seed})));
                rays.Add(mean(LinksByRays(field, {.rays = 256, .seed = seed})));
            }
            EXPECT_LE(Excess(slices, 1, WorstQuadrature(field, 32)), 1) << slices.Mean();
            EXPECT_LE(Excess(rays, 1, 1.0 / 256), 1) << rays.Mean();
            // And the chance is small enough for the test to say something.
            EXPECT_LT(slices.StandardError(), 2e-3);
            EXPECT_LT(rays.StandardError(), 2e-3);
            EXPECT_LT(WorstQuadrature(field, 32), amplitude > 2 ? 2e-2 : 2e-3);
        }
    }
}

// Expected: with all light leaving through the aperture, what is absorbed there,
// (1 - rho) Sum A_i E_i, is between (1 - rho) A (no light lost: E >= V, mean V / n_z = 1) and
// A. The aperture identity holds to chance only, so that much is allowed.
TEST(Laws, EffectiveAlbedoLiesBetweenZeroAndTheAlbedo) {
    const HeightField field = RoughField(10, 8, 6);
    for (const double rho : {0.2, 0.5, 0.9, 1.0}) {
        Moments effective;
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            const Links links = LinksBySlices(field, {.seed = seed});
            const TotalLight light =
                SolveTotal(links, std::vector<double>(links.V.size(), rho));
            double sum = 0;
            for (std::int64_t i = 0; i < field.Facets(); ++i) {
                sum += light.E[i] / FacetOf(field, i).normal.z();
            }
            effective.Add(1 - (1 - rho) * sum / double(field.Facets()));
        }
        const double slack = effective.HalfWidth(1 - kLevel) + 1e-9;
        EXPECT_GE(effective.Mean(), -slack);
        EXPECT_LE(effective.Mean(), rho + slack);
        EXPECT_LT(slack, 0.02);
    }
}

// The discrete measure of the slices with azimuths 2 pi (k + 1/2) / N about a normal n, in
// which alpha and V are exact integrals.
class SliceMeasure {
  public:
    SliceMeasure(const Vec3& n, int slices) : n_z_(n.z()) {
        for (int k = 0; k < slices; ++k) {
            const double phi = 2 * kPi * (k + 0.5) / slices;
            c_.push_back(n.x() * std::cos(phi) + n.y() * std::sin(phi));
        }
    }

    // Shares of the solid angle and of the cosine measure where n . w < x. In a slice
    // n . w = a cos(th - th_0), and the hemisphere ends at th_0 + pi/2.
    std::pair<double, double> Below(double x) const {
        double solid = 0, cosine = 0, solid_all = 0, cosine_all = 0;
        for (const double c : c_) {
            const double a = std::hypot(c, n_z_), th_0 = std::atan2(c, n_z_);
            const double end = th_0 + kPi / 2;
            const double wide = x < a ? std::acos(x / a) : 0;
            const auto add = [&](double from, double to) {
                if (from >= to) return;
                solid += std::cos(from) - std::cos(to);
                cosine += G(c, to) - G(c, from);
            };
            add(std::max(0.0, th_0 + wide), end);
            add(0, std::min(th_0 - wide, end));
            solid_all += 1 - std::cos(end);
            cosine_all += G(c, end);
        }
        return {solid / solid_all, cosine / cosine_all};
    }

    // The least V of all open sets with this alpha: the directions nearest the horizon.
    double LeastV(double alpha) const {
        double low = 0, high = 1;
        for (int step = 0; step < 60; ++step) {
            const double middle = (low + high) / 2;
            (Below(middle).first < alpha ? low : high) = middle;
        }
        return Below(low).second;
    }

  private:
    double G(double c, double th) const {
        return (c * (th - std::sin(th) * std::cos(th)) + n_z_ * std::sin(th) * std::sin(th)) /
               2;
    }
    double n_z_;
    std::vector<double> c_;
};

// Expected: alpha^2 <= V <= alpha (2 - alpha). That is the bathtub argument over the uniform
// hemisphere; a finite set of slices is another measure, in which the same argument holds with
// the share of the cosine measure in the lowest and highest directions of solid angle alpha:
// checked to the rounding of a row. On level facets the two measures agree, and the law itself
// holds to rounding; on tilted ones they differ by the quadrature error, stated here for 64.
TEST(Laws, VLiesBetweenItsBoundsInAlpha) {
    for (const int slices : {8, 16, 64}) {
        for (const double amplitude : {0.7, 5.0}) {
            const HeightField field = RoughField(8, 7, amplitude);
            const Links links = LinksBySlices(
                field, {.slices = slices, .rotate = false, .horizon_tolerance_rad = 1e-9});
            for (std::int64_t i = 0; i < links.Facets(); ++i) {
                const SliceMeasure measure(FacetOf(field, i).normal, slices);
                const double alpha = links.alpha[i], V = links.V[i];
                ASSERT_GE(V, measure.LeastV(alpha) - 2 * kFloatRow) << "facet " << i;
                ASSERT_LE(V, 1 - measure.LeastV(1 - alpha) + 2 * kFloatRow) << "facet " << i;
                if (slices == 64) {
                    ASSERT_GE(V, alpha * alpha - 2e-3) << "facet " << i;
                    ASSERT_LE(V, alpha * (2 - alpha) + 2e-3) << "facet " << i;
                }
            }
        }
    }
}

// Rays, uniform: ray cosines fill N = 2^m strata of [0, 1] with one each, so m open rays have a
// sum of cosines between those of the lowest and highest m strata.
TEST(Laws, VLiesBetweenItsBoundsInAlphaByRays) {
    const int N = 64;
    const Links links = LinksByRays(RoughField(8, 7, 5), {.rays = N});
    for (std::int64_t i = 0; i < links.Facets(); ++i) {
        const double open = links.alpha[i] * N, closed = N - open;
        const double least = open * (open - 1) / (double(N) * (N + 1));
        const double most = 1 - closed * (closed - 1) / (double(N) * (N + 1));
        ASSERT_NEAR(open, std::round(open), 1e-9);
        ASSERT_GE(links.V[i], least - 2 * kFloatRow);
        ASSERT_LE(links.V[i], most + 2 * kFloatRow);
    }
}

TEST(Laws, LevelGroundSeesTheWholeSkyAndNothingElse) {
    for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror, Boundary::kOpen}) {
        const HeightField flat = MakeFlat({.width_texels = 20,
                                           .height_texels = 30,
                                           .spacing_m = 0.3,
                                           .height_m = 0.1,
                                           .boundary = boundary});
        for (const Links& links : {LinksBySlices(flat), LinksByRays(flat, {.rays = 64})}) {
            EXPECT_EQ(links.Count(), 0);
            EXPECT_EQ(links.mean_cut_short, 0);
            for (std::int64_t i = 0; i < links.Facets(); ++i) {
                ASSERT_EQ(links.alpha[i], 1);
                ASSERT_EQ(links.V[i], 1);
            }
            ForEachBounce(links, 3, [](int k, std::span<const double> E_k) {
                for (const double e : E_k) ASSERT_EQ(e, k == 0 ? 1 : 0);
            });
        }
    }
}

// A plane sees nothing of itself, however inclined. Facets of one plane may find each other
// above themselves by a rounding, 1e-16 of the hemisphere each.
TEST(Laws, AnInclinedPlaneSeesTheWholeSky) {
    const HeightField plane =
        MakeTilted({.width_texels = 30, .height_texels = 20, .slope_x = 1.3, .slope_y = -0.7});
    for (const Links& links : {LinksBySlices(plane), LinksByRays(plane, {.rays = 64})}) {
        for (std::int64_t i = 0; i < links.Facets(); ++i) {
            ASSERT_NEAR(links.alpha[i], 1, 1e-13);
            ASSERT_NEAR(links.V[i], 1, 1e-13);
        }
        EXPECT_EQ(links.Count(), 0);
    }
}

}  // namespace
}  // namespace plumb
